#include "app/editor/window/help.h"

#include <QMessageBox>

#include <array>

namespace esm {

namespace {

struct Key {
    const char *keys, *does;
};

constexpr std::array<Key, 14> keysAndMouse{{
    {"Right drag, or Alt + left drag", "turn the view"},
    {"Middle drag, or Shift + right drag", "shift the view"},
    {"Wheel", "come closer, go away"},
    {"1 to 6, Home", "look from a side, show the whole organ"},
    {"P", "pull the tissue"},
    {"I", "push it with the instrument; Shift + wheel pushes deeper"},
    {"E", "move and size the selected region"},
    {"J", "move and size the selected photo"},
    {"V", "look and select"},
    {"Space, Ctrl+0", "play or pause, back to rest"},
    {"S, H", "show springs, hide regions"},
    {"C", "throw the selected photo from where you look"},
    {"Ctrl+1, Ctrl+2", "tissue, texture"},
    {"Ctrl+Z, Ctrl+Shift+Z", "undo, redo"},
}};

} // namespace

void showKeys(QWidget* window) {
    QString rows;
    for (const Key& key : keysAndMouse)
        rows +=
            QStringLiteral(
                "<tr><td style='padding:3px 24px 3px 0'><b>%1</b></td><td style='padding:3px 0'>%2</td></tr>")
                .arg(QObject::tr(key.keys), QObject::tr(key.does));
    QMessageBox box(QMessageBox::NoIcon, QObject::tr("Keys and mouse"),
                    QStringLiteral("<table>%1</table>").arg(rows), QMessageBox::Ok, window);
    box.exec();
}

void showAbout(QWidget* window) {
    QMessageBox::about(
        window, QObject::tr("About"),
        QObject::tr("<b>Elastodynamic Shape Modeler</b> %1<p>Authors deformable organ models for surgical "
                    "simulators: tissue in words, endoscopic photographs without distortion.<p>MIT licence.")
            .arg(QStringLiteral(ESM_VERSION)));
}

} // namespace esm

#include "app/editor/window/help.h"

#include "widgets/view/view_tool.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QVBoxLayout>

namespace esm {

namespace {

QString row(const QString& keys, const QString& does) {
    return QStringLiteral("<tr><td style='padding:2px 20px 2px 0; white-space:nowrap'><b>%1</b></td>"
                          "<td style='padding:2px 40px 2px 0; white-space:nowrap'>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), does.toHtmlEscaped());
}

QString actionRow(const QAction* action) {
    const QString keys = QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
    return row(QString(keys).replace(QStringLiteral("; "), QStringLiteral(", ")),
               action->text().remove('&').remove(QChar(0x2026)));
}

QString viewRows() {
    return row(QObject::tr("Right drag, Alt + left drag"), QObject::tr("turn the view")) +
           row(QObject::tr("Middle drag, Shift + drag"), QObject::tr("shift the view")) +
           row(QObject::tr("Wheel"), QObject::tr("come closer, go away")) +
           row(QObject::tr("1 to 6; F, B, L, R, T"),
               QObject::tr("look from the front, back, left, right, top, bottom"));
}

QString toolRows(const Actions& a) {
    QString rows;
    for (const auto& [action, tool] :
         {std::pair(a.look, ViewTool::Select), std::pair(a.pull, ViewTool::Pull),
          std::pair(a.instrument, ViewTool::Instrument), std::pair(a.region, ViewTool::Region),
          std::pair(a.projector, ViewTool::Projector)})
        rows += row(action->shortcut().toString(QKeySequence::NativeText), toolHint(tool));
    return rows + actionRow(a.letGo);
}

QString fieldRows() {
    return row(QObject::tr("Up, Down; with Shift"), QObject::tr("step a number; ten steps at once")) +
           row(QObject::tr("Enter, Esc"), QObject::tr("take what is typed, or take it back")) +
           row(QObject::tr("F2, Del"), QObject::tr("rename or remove the selected region or photo"));
}

QString actionRows(std::initializer_list<const QAction*> actions) {
    QString rows;
    for (const QAction* action : actions)
        rows += actionRow(action);
    return rows;
}

} // namespace

QString keysText(const Actions& a) {
    return QStringLiteral("<table><tr><td><table>%1%2%3</table></td><td><table>%4</table></td></tr></table>")
        .arg(viewRows(), toolRows(a), fieldRows(),
             actionRows({a.open,     a.import,    a.save,      a.saveAs,   a.exportPackage, a.quit,
                         a.undo,     a.redo,      a.addRegion, a.addPhoto, a.fromCamera,    a.play,
                         a.reset,    a.tissue,    a.texture,   a.frame,    a.showSprings,   a.showRegions,
                         a.showLeft, a.showRight, a.keys}));
}

void showKeys(QWidget* window, const Actions& actions) {
    QDialog dialog(window);
    dialog.setWindowTitle(QObject::tr("Keys and mouse"));
    dialog.setObjectName(QStringLiteral("keysDialog"));
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    column->addWidget(new QLabel(keysText(actions), &dialog));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    column->addWidget(buttons);
    dialog.exec();
}

void showAbout(QWidget* window) {
    QMessageBox::about(
        window, QObject::tr("About"),
        QObject::tr("<b>Elastodynamic Shape Modeler</b> %1<p>Authors deformable organ models for surgical "
                    "simulators: tissue in words, endoscopic photographs without distortion.<p>MIT licence.")
            .arg(QStringLiteral(ESM_VERSION)));
}

} // namespace esm

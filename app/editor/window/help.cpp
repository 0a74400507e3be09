#include "app/editor/window/help.h"

#include "app/editor/tools/tool_table.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace esm {

namespace {

QString row(const QString& keys, const QString& does) {
    return QStringLiteral("<tr><td style='padding:2px 18px 2px 0; white-space:nowrap'><b>%1</b></td>"
                          "<td style='padding:2px 14px 2px 0; white-space:nowrap'>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), does.toHtmlEscaped());
}

QString title(const QString& text) {
    return QStringLiteral("<tr><td colspan='2' style='padding:10px 0 4px 0'><i>%1</i></td></tr>")
        .arg(text.toHtmlEscaped());
}

QString keysOf(const QAction* action) {
    return QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText)
        .replace(QStringLiteral("; "), QStringLiteral(", "));
}

QString actionRow(const QAction* action) {
    return row(keysOf(action), action->text().remove('&').remove(QChar(0x2026)));
}

QString viewRows(const Actions& a) {
    QString rows = row(QObject::tr("Right drag, Alt + left drag"), QObject::tr("Turn the view")) +
                   row(QObject::tr("Middle drag, Shift + either"), QObject::tr("Shift the view")) +
                   row(QObject::tr("Wheel"), QObject::tr("Come closer, up to the surface, and go away")) +
                   actionRow(a.frame) + actionRow(a.frameSelection) + actionRow(a.lookFromWithin) +
                   actionRow(a.orthographic) + actionRow(a.cut);
    const QStringList sides{QObject::tr("Look from the front"), QObject::tr("Look from the back"),
                            QObject::tr("Look from the left"),  QObject::tr("Look from the right"),
                            QObject::tr("Look from the top"),   QObject::tr("Look from the bottom")};
    for (int i = 0; i < sides.size(); ++i)
        rows += row(keysOf(a.standardViews[static_cast<std::size_t>(i)]), sides[i]);
    return rows;
}

QString toolRows(const Actions& a) {
    QString rows;
    for (const ToolRow& tool : toolTable())
        rows += row(keysOf(a.tool(tool.name)),
                    QObject::tr("%1: %2").arg(QString(tool.text).remove('&'), tool.use));
    return rows + actionRow(a.letGo);
}

QString fieldRows() {
    return row(QObject::tr("Up, Down; with Shift"), QObject::tr("Step a number; ten steps at once")) +
           row(QObject::tr("Enter, Esc"), QObject::tr("Take what is typed, or take it back")) +
           row(QObject::tr("F2, Del"), QObject::tr("Rename or remove the selected region or photo")) +
           row(QObject::tr("Ctrl+Up, Ctrl+Down, drag"), QObject::tr("Lay it over or under its neighbours"));
}

QString actionRows(std::initializer_list<const QAction*> actions) {
    QString rows;
    for (const QAction* action : actions)
        rows += actionRow(action);
    return rows;
}

} // namespace

QString keysText(const Actions& a) {
    const QString mouse = title(QObject::tr("View")) + viewRows(a) + title(QObject::tr("Tools")) +
                          toolRows(a) + title(QObject::tr("Fields and lists")) + fieldRows();
    const QString keys =
        title(QObject::tr("Project")) +
        actionRows({a.open, a.import, a.save, a.saveAs, a.exportPackage, a.quit}) +
        row(keysOf(a.undo), QObject::tr("Undo")) + row(keysOf(a.redo), QObject::tr("Redo")) +
        actionRow(a.history) + title(QObject::tr("Tissue and photos")) +
        actionRows({a.addRegion, a.duplicateRegion, a.addPhoto, a.addPaint, a.fromCamera, a.play, a.playScene,
                    a.reset}) +
        title(QObject::tr("Window and what it shows")) +
        actionRows({a.tissue, a.texture, a.showSurface, a.showWireframe, a.showSprings, a.showNodes,
                    a.showRegions, a.showLeft, a.showRight, a.fuzzyWindow, a.keys});
    return QStringLiteral("<table><tr><td><table>%1</table></td><td><table>%2</table></td></tr></table>")
        .arg(mouse, keys);
}

void showKeys(QWidget* window, const Actions& actions) {
    QDialog dialog(window);
    dialog.setWindowTitle(QObject::tr("Keys and mouse"));
    dialog.setObjectName(QStringLiteral("keysDialog"));
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(20, 18, 20, 18);
    column->setSpacing(12);
    auto* sheet = new QScrollArea(&dialog);
    sheet->setFrameShape(QFrame::NoFrame);
    sheet->setAccessibleName(dialog.windowTitle());
    sheet->setToolTip(QObject::tr("The arrow keys scroll"));
    sheet->setWidget(new QLabel(keysText(actions)));
    column->addWidget(sheet);
    // As large as the sheet, where the screen has room for it.
    const QSize frame(2 * 20 + sheet->style()->pixelMetric(QStyle::PM_ScrollBarExtent), 140);
    dialog.resize(
        (sheet->widget()->sizeHint() + frame).boundedTo(window->screen()->availableSize() - QSize(40, 80)));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok, &dialog);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(QObject::tr("Close the sheet"));
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

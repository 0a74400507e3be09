#include "app/editor/window/help.h"

#include "app/editor/dialogs/screen_room.h"
#include "app/editor/tools/tool_table.h"
#include "app/editor/window/shortcuts.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace esm {

namespace {

QString row(const QString& keys, const QString& does) {
    return QStringLiteral("<tr><td style='padding:2px 18px 2px 0; white-space:nowrap'><b>%1</b></td>"
                          "<td style='padding:2px 14px 2px 0'>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), does.toHtmlEscaped());
}

QString title(const QString& text) {
    return QStringLiteral("<tr><td colspan='2' style='padding:10px 0 4px 0'><i>%1</i></td></tr>")
        .arg(text.toHtmlEscaped());
}

QString rowOf(const ShortcutRow& entry) {
    const QString keys = shownKeys(entry.action->shortcuts());
    return keys.isEmpty() ? QString() : row(keys, entry.name);
}

bool isOfCamera(const ShortcutRow& entry) {
    return entry.id == "frame" || entry.id == "frameSelection" || entry.id == "cut" ||
           entry.id == "orthographic" || entry.id == "endoscopeLight" || entry.id == "lookFromWithin" ||
           entry.id == "lookThroughPhoto" || entry.id.startsWith("lookFrom/");
}

QString viewRows(const std::vector<ShortcutRow>& actions) {
    QString rows = row(QObject::tr("Right drag, Alt + left drag"), QObject::tr("Turn the view")) +
                   row(QObject::tr("Middle drag, Shift + either"), QObject::tr("Shift the view")) +
                   row(QObject::tr("Wheel"), QObject::tr("Come closer, up to the surface, and go away"));
    for (const ShortcutRow& entry : actions)
        if (isOfCamera(entry)) rows += rowOf(entry);
    return rows;
}

/// The mouse's work by the keys: see KeyPointer.
QString markRows() {
    return row(QObject::tr("Arrows; with Shift"), QObject::tr("Move a mark over the view; by a pixel")) +
           row(QObject::tr("Enter"), QObject::tr("Press the left button at the mark, and let it go again")) +
           row(QObject::tr("Tab"), QObject::tr("Bring the mark to the next handle")) +
           row(QObject::tr("Page Up, Page Down"), QObject::tr("Turn the wheel at the mark"));
}

QString toolRow(const QAction* tool, const QString& use) {
    return row(shownKeys(tool->shortcuts()), QObject::tr("%1: %2").arg(plainText(tool), use));
}

QString toolRows(const Actions& a) {
    QString rows;
    for (const ToolRow& tool : toolTable())
        rows += toolRow(a.tool(tool.name), tool.use);
    return rows + row(shownKeys(a.letGo->shortcuts()), plainText(a.letGo));
}

QString fieldRows() {
    return row(QObject::tr("Up, Down; with Shift"), QObject::tr("Step a number; ten steps at once")) +
           row(QObject::tr("Enter, Esc"), QObject::tr("Take what is typed, or take it back")) +
           row(QObject::tr("F2, Del"), QObject::tr("Rename or remove the selected region or photo")) +
           row(QObject::tr("Ctrl+Up, Ctrl+Down, drag"), QObject::tr("Lay it over or under its neighbours"));
}

/// All that has a key and stands nowhere else in the sheet, by its menu.
QString menuRows(const std::vector<ShortcutRow>& actions, const Actions& a) {
    QString rows, group;
    for (const ShortcutRow& entry : actions) {
        const bool isTool = entry.action == a.letGo || a.tools->actions().contains(entry.action);
        const QString told = isTool || isOfCamera(entry) ? QString() : rowOf(entry);
        if (told.isEmpty()) continue;
        if (entry.group != group) rows += title(entry.group);
        group = entry.group;
        rows += told;
    }
    return rows;
}

} // namespace

QString keysText(const Actions& a, SheetColumns columns) {
    const std::vector<ShortcutRow> actions = shortcutRows(a);
    const QString mouse = title(QObject::tr("View")) + viewRows(actions) +
                          title(QObject::tr("View by the keys alone")) + markRows() +
                          title(QObject::tr("Tools")) + toolRows(a) + title(QObject::tr("Fields and lists")) +
                          fieldRows();
    const QString keys = menuRows(actions, a);
    const QString next =
        columns == SheetColumns::Two ? QStringLiteral("</table></td><td><table>") : QString();
    return QStringLiteral("<table><tr><td><table>%1%2%3</table></td></tr></table>").arg(mouse, next, keys);
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
    auto* text = new QLabel(keysText(actions, SheetColumns::Two));
    const QSize frame(2 * 20 + sheet->style()->pixelMetric(QStyle::PM_ScrollBarExtent), 140);
    // In a narrow screen one column, whose lines are broken.
    if (text->sizeHint().width() + frame.width() > roomOnScreen(*window).width())
        text->setText(keysText(actions, SheetColumns::One));
    dialog.resize(text->sizeHint() + frame);
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignTop);
    sheet->setWidget(text);
    sheet->setWidgetResizable(true);
    column->addWidget(sheet);
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

#include "app/editor/dialogs/preset_question.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/box_setup.h"
#include "widgets/fuzzy/term_scale.h"

#include <QMessageBox>
#include <QPushButton>

namespace esm {

namespace {

QString cell(const QString& text) {
    return QStringLiteral("<td style='padding-right:14px'>%1</td>").arg(text.toHtmlEscaped());
}

QString changeTable(const std::vector<PresetChange>& changes) {
    if (changes.empty()) return QObject::tr("<p>Nothing would change: the tissue is so already.</p>");
    QString rows;
    for (const PresetChange& change : changes)
        rows += QStringLiteral("<tr>%1%2%3</tr>")
                    .arg(cell(readableName(change.what)), cell(QString::fromStdString(change.before)),
                         cell(QStringLiteral("→ ") + QString::fromStdString(change.after)));
    return QStringLiteral("<table>%1</table>").arg(rows);
}

QString paragraph(const std::string& text) {
    return QStringLiteral("<p>%1</p>").arg(QString::fromStdString(text).toHtmlEscaped());
}

} // namespace

bool mayApplyPreset(QWidget& window, const TissuePreset& preset, const QString& target,
                    const std::vector<PresetChange>& changes) {
    return ask(window, [&] {
        QMessageBox box(
            QMessageBox::NoIcon, QObject::tr("Published tissue"),
            QObject::tr("“%1” for “%2” changes:").arg(QString::fromStdString(preset.title), target),
            QMessageBox::Cancel, &window);
        setUpBox(box, "presetBox");
        box.setInformativeText(changeTable(changes) + paragraph(preset.description) +
                               paragraph("Source: " + preset.source));
        QPushButton* apply = box.addButton(QObject::tr("&Apply"), QMessageBox::AcceptRole);
        apply->setObjectName(QStringLiteral("applyPreset"));
        apply->setEnabled(!changes.empty());
        apply->setToolTip(changes.empty() ? QObject::tr("The tissue is so already")
                                          : QObject::tr("Set the tissue so, in one step that can be undone"));
        box.button(QMessageBox::Cancel)->setToolTip(QObject::tr("Keep the tissue as it is"));
        box.setDefaultButton(apply);
        if (changes.empty()) box.setDefaultButton(QMessageBox::Cancel);
        box.exec();
        return box.clickedButton() == apply;
    });
}

} // namespace esm

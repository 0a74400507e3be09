#include "app/editor/panels/tissue/tissue_preset_button.h"

#include "app/editor/dialogs/preset_question.h"
#include "core/exchange/project/tissue_preset_file.h"

#include <QCursor>
#include <QMenu>

namespace esm {

namespace {

QString presetToolTip(const TissuePreset& preset, bool isPart) {
    QStringList parts{QString::fromStdString(preset.description),
                      (isMeasured(preset) ? QObject::tr("Measured: %1.") : QObject::tr("Published: %1."))
                          .arg(QString::fromStdString(publishedText(preset))),
                      QString::fromStdString(preset.source)};
    if (!isMeasured(preset))
        parts << QObject::tr("Taken as published, whatever the size of this organ and the number of its "
                             "springs: nothing is scaled.");
    if (isPart && preset.system)
        parts << QObject::tr("The selected region takes the tissue; mass and tethers are for a whole organ.");
    QString text; // rich, so that it is wrapped
    for (const QString& part : parts)
        text += QStringLiteral("<p>%1</p>").arg(part.toHtmlEscaped());
    return text;
}

/// Styles need not show the titles that QMenu has for sections.
void addHeading(QMenu& menu, const QString& title) {
    menu.addAction(title)->setEnabled(false);
}

} // namespace

TissuePresetButton::TissuePresetButton(Document& document, Selection& selection, QWidget* parent)
    : QToolButton(parent), m_document(document), m_selection(selection) {
    setObjectName(QStringLiteral("headerButton"));
    setText(tr("preset…"));
    setToolTip(
        tr("Tissue for what is selected: as it was measured, from brain to cartilage, or as simulators "
           "published it. Each says where it is from"));
    setAccessibleName(tr("Published tissue"));
    setPopupMode(QToolButton::InstantPopup);
    setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    menu->setObjectName(QStringLiteral("presets"));
    setMenu(menu);
    connect(menu, &QMenu::aboutToShow, this, &TissuePresetButton::fill);
    // While the menu is open, nobody tells the button that the mouse has left it.
    connect(menu, &QMenu::aboutToHide, this, [this] {
        setAttribute(Qt::WA_UnderMouse, rect().contains(mapFromGlobal(QCursor::pos())));
        update();
    });
    fill();
}

bool TissuePresetButton::isPartSelected() const {
    const Region* region = m_selection.selectedRegion();
    return region && region->ellipsoid;
}

void TissuePresetButton::fill() {
    menu()->clear();
    addHeading(*menu(), tr("Tissue as it was measured"));
    bool isOfSimulator = false;
    for (const std::string& name : tissuePresetNames()) {
        const TissuePreset preset = tissuePreset(name);
        if (!isOfSimulator && !isMeasured(preset)) addHeading(*menu(), tr("Tissue of published simulators"));
        isOfSimulator = !isMeasured(preset);
        QAction* action = menu()->addAction(QString::fromStdString(preset.title) + QStringLiteral("…"));
        action->setObjectName(QString::fromStdString(name));
        action->setToolTip(presetToolTip(preset, isPartSelected()));
        connect(action, &QAction::triggered, this, [this, name] { apply(name); });
    }
}

void TissuePresetButton::apply(const std::string& presetName) {
    const TissuePreset preset = tissuePreset(presetName);
    const RegionId region = m_selection.region().value_or(m_document.newRegionId());
    const Region* selected = m_selection.selectedRegion();
    const bool isForPart = selected && (preset.system || selected->ellipsoid == std::nullopt);
    const QString name = isForPart ? QString::fromStdString(selected->name) : tr("Whole organ");
    if (!mayApplyPreset(*window(), preset, name, presetChanges(m_document.project(), region, preset))) return;
    std::optional<RegionId> target;
    m_document.edit(tr("Tissue of preset “%1”").arg(QString::fromStdString(preset.title)),
                    [&](Project& project) { target = applyPreset(project, region, preset); });
    if (target) m_selection.setRegion(target);
}

} // namespace esm

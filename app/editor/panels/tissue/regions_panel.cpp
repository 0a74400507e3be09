#include "app/editor/panels/tissue/regions_panel.h"

#include "core/authoring/regions.h"
#include "widgets/inputs/number_text.h"

namespace esm {

namespace {

QColor toQColor(const std::array<std::uint8_t, 3>& colour) {
    return {colour[0], colour[1], colour[2]};
}

} // namespace

RegionsPanel::RegionsPanel(Document& document, Selection& selection, QWidget* parent)
    : LayersPanel(tr("Regions"), QPalette::Link,
                  {tr("Lay over the region above (Ctrl+Up)"), tr("Lay under the region below (Ctrl+Down)"),
                   tr("Remove the region (Del)")},
                  parent),
      m_document(document), m_selection(selection) {
    list()->setObjectName(QStringLiteral("regionList"));
    list()->setAccessibleDescription(
        tr("A region lies over those beneath it in the list: where they overlap, the upper one counts"));
    connect(&selection, &Selection::changed, this, &RegionsPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) show();
    });
    RegionsPanel::show();
}

void RegionsPanel::show() {
    const Project& project = m_document.project();
    std::vector<ItemRow> rows;
    for (std::size_t i = project.regions.size(); i-- > 0;) {
        const Region& region = project.regions[i];
        const QString count = countText(m_counts.of(project, region).nodes);
        rows.push_back({QString::fromStdString(region.name), count, toQColor(region.colour), {}, true});
    }
    if (!wholeOrganRegion(project)) {
        const QString count = countText(project.network->restPositions.size());
        rows.push_back({tr("Whole organ"), count, QColor(152, 161, 171), {}, false});
    }
    const auto selected = selectedLayer();
    list()->setRows(rows, selected ? rowOf(*selected) : static_cast<int>(rows.size() - 1));
    showButtons(obstacles());
}

LayersPanel::Obstacles RegionsPanel::obstacles() const {
    const auto selected = selectedLayer();
    const QString whole = tr("The whole organ always lies beneath the regions");
    if (!selected) return {whole, whole, tr("The whole organ cannot be removed")};
    if (!m_document.project().regions[*selected].ellipsoid && *selected == 0) return {whole, whole, {}};
    return {canMoveLayer(*selected, 1) ? QString() : tr("This region already lies on top"),
            canMoveLayer(*selected, -1) ? QString() : tr("No region lies beneath this one"),
            {}};
}

std::optional<std::size_t> RegionsPanel::selectedLayer() const {
    const auto region = m_selection.region();
    return region ? placeOf(m_document.project().regions, *region) : std::nullopt;
}

void RegionsPanel::selectLayer(std::optional<std::size_t> layer) {
    m_selection.setRegion(layer ? std::optional(regionAt(*layer)) : std::nullopt);
}

bool RegionsPanel::canMoveLayer(std::size_t layer, int above) const {
    return canMoveRegion(m_document.project(), regionAt(layer), above);
}

void RegionsPanel::moveLayer(std::size_t layer, int above) {
    m_document.edit(tr("Reorder regions"),
                    [id = regionAt(layer), above](Project& project) { moveRegion(project, id, above); });
}

void RegionsPanel::removeLayer(std::size_t layer) {
    m_document.edit(tr("Remove region"),
                    [id = regionAt(layer)](Project& project) { removeRegion(project, id); });
}

void RegionsPanel::renameLayer(std::size_t layer, const std::string& name) {
    m_document.edit(tr("Rename region"), [&](Project& project) { project.regions[layer].name = name; });
}

} // namespace esm

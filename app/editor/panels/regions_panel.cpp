#include "app/editor/panels/regions_panel.h"

#include "app/editor/commands/region_edits.h"
#include "widgets/inputs/icon.h"
#include "widgets/inputs/number_text.h"

namespace esm {

namespace {

QColor toQColor(const std::array<std::uint8_t, 3>& colour) {
    return {colour[0], colour[1], colour[2]};
}

} // namespace

RegionsPanel::RegionsPanel(Document& document, Selection& selection, QWidget* parent)
    : Section(tr("Regions"), parent), m_document(document), m_selection(selection),
      m_list(new ItemList(QPalette::Link, this)) {
    m_up = addHeaderIcon(icon(QStringLiteral("up")), tr("Lay over the region above"));
    m_down = addHeaderIcon(icon(QStringLiteral("down")), tr("Lay under the region below"));
    m_remove = addHeaderIcon(icon(QStringLiteral("remove")), tr("Remove the region (Del)"));
    QToolButton* add = addHeaderButton(tr("+ add"), tr("Add an ellipsoid region (Ctrl+R)"));
    add->setProperty("adds", QStringLiteral("region"));
    m_list->setObjectName(QStringLiteral("regionList"));
    m_list->setAccessibleName(tr("Regions"));
    body()->addWidget(m_list);

    connect(add, &QToolButton::clicked, this, &RegionsPanel::addRegion);
    connect(m_up, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_remove, &QToolButton::clicked, this, &RegionsPanel::removeSelected);
    connect(m_list, &ItemList::removeRequested, this, &RegionsPanel::removeSelected);
    connect(m_list, &ItemList::rowRenamed, this, &RegionsPanel::rename);
    connect(m_list, &ItemList::rowSelected, this,
            [this](int row) { m_selection.setRegion(regionOfRow(row)); });
    connect(&selection, &Selection::changed, this, &RegionsPanel::show);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) show();
    });
    show();
}

std::optional<std::size_t> RegionsPanel::regionOfRow(int row) const {
    const std::size_t count = m_document.project().regions.size();
    if (row < 0 || static_cast<std::size_t>(row) >= count) return std::nullopt;
    return count - 1 - static_cast<std::size_t>(row);
}

void RegionsPanel::show() {
    const Project& project = m_document.project();
    std::vector<ItemRow> rows;
    for (std::size_t i = project.regions.size(); i-- > 0;) {
        const Region& region = project.regions[i];
        const QString count = countText(nodesInside(*project.network, region).size());
        rows.push_back({QString::fromStdString(region.name), count, toQColor(region.colour), {}, true});
    }
    if (!wholeOrganRegion(project)) {
        const QString count = countText(project.network->restPositions.size());
        rows.push_back({tr("Whole organ"), count, QColor(152, 161, 171), {}, false});
    }
    const auto selected = m_selection.region();
    m_list->setRows(rows,
                    static_cast<int>(selected ? project.regions.size() - 1 - *selected : rows.size() - 1));
    showButtons();
}

void RegionsPanel::showButtons() {
    const Project& project = m_document.project();
    const auto selected = m_selection.region();
    const auto enable = [](QToolButton* button, bool on, const QString& does, const QString& why) {
        button->setEnabled(on);
        button->setToolTip(on ? does : why);
    };
    const QString whole = tr("The whole organ always lies beneath the regions");
    enable(m_up, selected && canMoveRegion(project, *selected, 1), tr("Lay over the region above"),
           selected && *selected > 0 ? tr("This region already lies on top") : whole);
    enable(m_down, selected && canMoveRegion(project, *selected, -1), tr("Lay under the region below"),
           selected && project.regions[*selected].ellipsoid ? tr("No region lies beneath this one") : whole);
    enable(m_remove, selected.has_value(), tr("Remove the region (Del)"),
           tr("The whole organ cannot be removed"));
}

void RegionsPanel::addRegion() {
    m_document.edit(tr("Add region"), [](Project& project) {
        esm::addRegion(project, boundingBox(project.network->restPositions).center());
    });
}

void RegionsPanel::removeSelected() {
    const auto selected = m_selection.region();
    if (!selected) return;
    m_document.edit(tr("Remove region"), [selected](Project& project) {
        project.regions.erase(project.regions.begin() + static_cast<std::ptrdiff_t>(*selected));
    });
}

void RegionsPanel::move(int above) {
    const auto selected = m_selection.region();
    if (!selected || !canMoveRegion(m_document.project(), *selected, above)) return;
    m_document.edit(tr("Reorder regions"), [=](Project& project) { moveRegion(project, *selected, above); });
    m_selection.setRegion(above > 0 ? *selected + 1 : *selected - 1);
}

void RegionsPanel::rename(int row, const QString& name) {
    const auto region = regionOfRow(row);
    if (region && !name.isEmpty())
        m_document.edit(tr("Rename region"),
                        [&](Project& project) { project.regions[*region].name = name.toStdString(); });
    // An empty name was not taken: the old one comes back.
    QMetaObject::invokeMethod(this, &RegionsPanel::show, Qt::QueuedConnection);
}

} // namespace esm

#include "app/editor/document/selection.h"

#include "app/editor/document/document.h"

#include <algorithm>

namespace esm {

namespace {

/// What is selected after a list has changed.
template<typename Part>
std::optional<Id<Part>> follow(std::optional<Id<Part>> selected, const std::vector<Part>& before,
                               const std::vector<Part>& now) {
    for (auto part = now.rbegin(); part != now.rend(); ++part)
        if (!findPart(before, part->id)) return part->id;
    if (!selected || findPart(now, *selected)) return selected;
    // Gone: its neighbour above takes its place, else the one below.
    if (now.empty()) return std::nullopt;
    return now[std::min(placeOf(before, *selected).value(), now.size() - 1)].id;
}

/// Of the parts that differ from what they were, the selected one, else the topmost; what is selected where
/// none does.
template<typename Part>
std::optional<Id<Part>> changedOne(std::optional<Id<Part>> selected, const std::vector<Part>& before,
                                   const std::vector<Part>& now) {
    const auto differs = [&](const Part& part) {
        const Part* former = findPart(before, part.id);
        return former && !(*former == part);
    };
    const Part* current = selected ? findPart(now, *selected) : nullptr;
    if (current && differs(*current)) return selected;
    const auto changed = std::find_if(now.rbegin(), now.rend(), differs);
    return changed == now.rend() ? selected : std::optional(changed->id);
}

} // namespace

Selection::Selection(Document& document) : QObject(&document), m_document(document) {
    followDocument(Change::everything());
    connect(&document, &Document::changed, this, &Selection::followDocument);
}

void Selection::setRegion(std::optional<RegionId> region) {
    if (region && !findPart(m_regions, *region)) region.reset();
    if (region == m_region) return;
    m_region = region;
    emit changed();
}

void Selection::setPhoto(std::optional<LayerId> photo) {
    if (photo && !findPart(m_photos, *photo)) photo.reset();
    if (photo == m_photo) return;
    m_photo = photo;
    emit changed();
}

const Region* Selection::selectedRegion() const {
    return m_region ? findPart(m_document.project().regions, *m_region) : nullptr;
}

const TextureLayer* Selection::selectedLayer() const {
    return m_photo ? findPart(m_document.project().layers, *m_photo) : nullptr;
}

void Selection::followDocument(const Change& change) {
    const Project& project = m_document.project();
    // Nothing of another organ is the same, though it may look so.
    if (change.mesh) {
        m_regions.clear();
        m_photos.clear();
    }
    auto region = change.mesh ? std::nullopt : m_region;
    // Where a region of the whole organ goes, the whole organ stays selected.
    const bool whole = region && !partOf(m_regions, *region).ellipsoid;
    region = follow(region, m_regions, project.regions);
    if (whole && project.regions.size() < m_regions.size() && region &&
        partOf(project.regions, *region).ellipsoid)
        region.reset();
    auto photo = follow(change.mesh ? std::nullopt : m_photo, m_photos, project.layers);
    if (change.isOfHistory) {
        region = changedOne(region, m_regions, project.regions);
        photo = changedOne(photo, m_photos, project.layers);
    }
    m_regions = project.regions;
    m_photos = project.layers;
    if (region == m_region && photo == m_photo) return;
    m_region = region;
    m_photo = photo;
    emit changed();
}

} // namespace esm

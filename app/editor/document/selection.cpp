#include "app/editor/document/selection.h"

#include "app/editor/document/document.h"

#include <algorithm>

namespace esm {

namespace {

/// Where two lists differ: what lies between their common beginning and their common end.
struct DifferingRange {
    std::size_t begin, endBefore, endNow;
};

template<typename Item>
DifferingRange differingRange(const std::vector<Item>& before, const std::vector<Item>& now) {
    const auto begin = static_cast<std::size_t>(
        std::mismatch(before.begin(), before.end(), now.begin(), now.end()).first - before.begin());
    std::size_t end = 0;
    while (end < std::min(before.size(), now.size()) - begin &&
           before[before.size() - 1 - end] == now[now.size() - 1 - end])
        ++end;
    return {begin, before.size() - end, now.size() - end};
}

template<typename Item>
std::optional<std::size_t> follow(std::optional<std::size_t> selected, const std::vector<Item>& before,
                                  const std::vector<Item>& now) {
    const DifferingRange range = differingRange(before, now);
    if (now.size() > before.size()) return range.endNow - 1;
    if (!selected || *selected < range.begin) return selected;
    if (*selected >= range.endBefore) return *selected - before.size() + now.size();
    for (std::size_t i = range.begin; i < range.endNow; ++i)
        if (before[*selected] == now[i]) return i;
    if (now.size() == before.size()) return selected;
    // Gone: its neighbour above takes its place, else the one below.
    if (now.empty()) return std::nullopt;
    return std::min(range.begin, now.size() - 1);
}

} // namespace

Selection::Selection(Document& document) : QObject(&document), m_document(document) {
    followDocument(Change::everything());
    connect(&document, &Document::changed, this, &Selection::followDocument);
}

void Selection::setRegion(std::optional<std::size_t> region) {
    if (region && *region >= m_regions.size()) region.reset();
    if (region == m_region) return;
    m_region = region;
    emit changed();
}

void Selection::setPhoto(std::optional<std::size_t> photo) {
    if (photo && *photo >= m_photos.size()) photo.reset();
    if (photo == m_photo) return;
    m_photo = photo;
    emit changed();
}

void Selection::followDocument(const Change& change) {
    const Project& project = m_document.project();
    // Nothing of another organ is the same, though it may look so.
    auto region = change.mesh ? std::nullopt : m_region, photo = change.mesh ? std::nullopt : m_photo;
    if (change.mesh) {
        m_regions.clear();
        m_photos.clear();
    }
    // Where a region of the whole organ goes, the whole organ stays selected.
    const bool whole = region && !m_regions[*region].ellipsoid;
    region = follow(region, m_regions, project.regions);
    if (whole && project.regions.size() < m_regions.size() && region && project.regions[*region].ellipsoid)
        region.reset();
    photo = follow(photo, m_photos, project.layers);
    m_regions = project.regions;
    m_photos = project.layers;
    if (region == m_region && photo == m_photo) return;
    m_region = region;
    m_photo = photo;
    emit changed();
}

} // namespace esm

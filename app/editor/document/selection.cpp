#include "app/editor/document/selection.h"

#include "app/editor/document/document.h"

namespace esm {

namespace {

/// What came last is selected when something was added; what is gone no longer is.
std::optional<std::size_t> follow(std::optional<std::size_t> selected, std::size_t before, std::size_t now) {
    if (now > before) return now - 1;
    if (!selected || *selected < now) return selected;
    return now > 0 ? std::optional(now - 1) : std::nullopt;
}

} // namespace

Selection::Selection(Document& document)
    : QObject(&document), m_document(document), m_regionCount(0), m_photoCount(0) {
    followDocument(Change::everything());
    connect(&document, &Document::changed, this, &Selection::followDocument);
}

void Selection::setRegion(std::optional<std::size_t> region) {
    if (region && *region >= m_regionCount) region.reset();
    if (region == m_region) return;
    m_region = region;
    emit changed();
}

void Selection::setPhoto(std::optional<std::size_t> photo) {
    if (photo && *photo >= m_photoCount) photo.reset();
    if (photo == m_photo) return;
    m_photo = photo;
    emit changed();
}

void Selection::followDocument(const Change& change) {
    if (change.mesh) m_regionCount = m_photoCount = 0;
    const std::size_t regions = m_document.project().regions.size(),
                      photos = m_document.project().photos.size();
    const auto region = follow(m_region, m_regionCount, regions);
    const auto photo = follow(m_photo, m_photoCount, photos);
    m_regionCount = regions;
    m_photoCount = photos;
    if (region == m_region && photo == m_photo) return;
    m_region = region;
    m_photo = photo;
    emit changed();
}

} // namespace esm

#include "core/texture/layers/composition_cache.h"

#include "core/geometry/adjacency.h"
#include "core/texture/layers/mask_feather.h"
#include "core/texture/layers/outline_feather.h"

#include <algorithm>

namespace esm {

namespace {

/// Finds an item that was used, or takes it over from before.
///
/// There are two generations: what the composition that runs has asked for, and what the one before had. An
/// item that is asked for moves over to the first; finish() drops what is left of the second. So nothing has
/// to guess how much may be kept: memory is that of what the latest composition needed.
template<typename Item, typename Same>
const Item* usedAgain(std::vector<Item>& used, std::vector<Item>& before, const Same& same) {
    const auto found = std::find_if(used.begin(), used.end(), same);
    if (found != used.end()) return &*found;
    const auto old = std::find_if(before.begin(), before.end(), same);
    if (old == before.end()) return nullptr;
    used.push_back(std::move(*old));
    before.erase(old);
    return &used.back();
}

} // namespace

std::shared_ptr<const SurfaceQuery> CompositionCache::queryOf(const TriangleMesh& mesh) {
    if (!m_query) m_query = std::make_shared<const SurfaceQuery>(mesh.vertices, mesh.triangles);
    return m_query;
}

std::shared_ptr<const TexelOwners> CompositionCache::ownersOf(const TriangleMesh& mesh, const Atlas& atlas,
                                                              const Progress& progress) {
    if (!m_owners || !m_owners->areOf(atlas))
        m_owners = std::make_shared<const TexelOwners>(mesh, atlas, progress);
    return m_owners;
}

SampledPicture CompositionCache::sampled(const std::shared_ptr<const Image>& picture) {
    const auto same = [&](const SampledPicture& item) { return item.picture == picture; };
    if (const SampledPicture* known = usedAgain(m_sampled.used, m_sampled.before, same)) return *known;
    m_sampled.used.push_back({picture, std::make_shared<const PhotoSampler>(*picture)});
    return m_sampled.used.back();
}

/// By projector and size alone: what hides what has nothing to do with the photo's colours, so a photo that
/// is prepared anew keeps it.
std::shared_ptr<const SurfaceLighting> CompositionCache::lightingOf(const ProjectedSize& projected,
                                                                    const TriangleMesh& mesh,
                                                                    const Progress& progress) {
    const auto same = [&](const ProjectorLighting& item) { return item.projected == projected; };
    if (const ProjectorLighting* known = usedAgain(m_lighting.used, m_lighting.before, same))
        return known->lighting;
    reportProgress(progress, 0);
    const auto& [projector, photo] = projected;
    auto lighting = std::make_shared<const SurfaceLighting>(SurfaceLighting{
        certainLighting(shadowCaster(mesh), projector, photo, progress), sidesOf(projector, mesh)});
    m_lighting.used.push_back({projected, lighting});
    return lighting;
}

std::shared_ptr<const PhotoFade> CompositionCache::fadeOf(const FadingPhoto& photo, const TriangleMesh& mesh,
                                                          const Progress& progress) {
    ProgressParts parts(progress);
    std::shared_ptr<const PhotoFade> outlines, masked;
    if (photo.projector.occlusion)
        outlines =
            outlinesOf({photo.projector, sizeOf(*photo.picture)}, photo.blendPixels, mesh, parts.next(0.8));
    if (photo.atMask) masked = maskFadeOf(photo.picture, photo.blendPixels, parts.rest());
    const bool hasOutlines = outlines && !outlines->faded.empty();
    const bool isMasked = masked && !masked->faded.empty();
    if (hasOutlines && isMasked) return std::make_shared<const PhotoFade>(fadedByBoth(*outlines, *masked));
    return hasOutlines ? outlines : isMasked ? masked : nullptr;
}

std::shared_ptr<const PhotoFade> CompositionCache::outlinesOf(const ProjectedSize& projected,
                                                              double blendPixels, const TriangleMesh& mesh,
                                                              const Progress& progress) {
    const auto same = [&](const ProjectorOutlines& item) {
        return item.projected == projected && item.blendPixels == blendPixels;
    };
    if (const ProjectorOutlines* known = usedAgain(m_outlines.used, m_outlines.before, same))
        return known->feather;
    const auto& [projector, photo] = projected;
    auto feather = std::make_shared<const PhotoFade>(
        outlineFeather(shadowCaster(mesh), *queryOf(mesh), projector, photo, blendPixels, progress));
    m_outlines.used.push_back({projected, blendPixels, feather});
    return feather;
}

std::shared_ptr<const PhotoFade> CompositionCache::maskFadeOf(const std::shared_ptr<const Image>& picture,
                                                              double blendPixels, const Progress& progress) {
    const auto same = [&](const MaskedPicture& item) {
        return item.picture == picture && item.blendPixels == blendPixels;
    };
    if (const MaskedPicture* known = usedAgain(m_masks.used, m_masks.before, same)) return known->feather;
    auto feather = std::make_shared<const PhotoFade>(maskFeather(*picture, blendPixels, progress));
    m_masks.used.push_back({picture, blendPixels, feather});
    return feather;
}

std::vector<SeenSide> CompositionCache::sidesOf(const Projector& projector, const TriangleMesh& mesh) {
    if (!m_parts) m_parts = connectedParts(mesh.triangles, mesh.vertices.size());
    return seenSides(mesh, *m_parts, projector);
}

ShadowCaster CompositionCache::shadowCaster(const TriangleMesh& mesh) {
    if (m_across.empty()) m_across = trianglesAcross(mesh.triangles);
    return {mesh, m_across, hidingTolerance(mesh)};
}

std::shared_ptr<const std::vector<Eigen::Vector3d>> CompositionCache::normalsOf(const TriangleMesh& mesh) {
    if (!m_normals)
        m_normals = std::make_shared<const std::vector<Eigen::Vector3d>>(
            vertexNormals(mesh.vertices, mesh.triangles));
    return m_normals;
}

std::shared_ptr<const HealingRim> CompositionCache::healed(const BrushStroke& stroke,
                                                           const std::vector<TextureLayer>& beneath,
                                                           std::array<std::uint8_t, 3> baseColour) {
    const auto same = [&](const HealedStroke& item) {
        return item.baseColour == baseColour && (item.stroke.get() == &stroke || *item.stroke == stroke) &&
               std::equal(beneath.begin(), beneath.end(), item.beneath.begin(), item.beneath.end(),
                          looksTheSame);
    };
    const HealedStroke* known = usedAgain(m_healed.used, m_healed.before, same);
    return known ? known->rim : nullptr;
}

/// What is blended in bands depends on all that lies beneath it. Names, and whatever else looksTheSame()
/// leaves out, must not blend it anew.
std::optional<SampledPicture> CompositionCache::banded(const TextureLayer& layer,
                                                       const std::vector<TextureLayer>& beneath,
                                                       std::array<std::uint8_t, 3> baseColour) {
    const auto same = [&](const BandedPicture& item) {
        return item.baseColour == baseColour && projectsTheSame(item.layer, layer) &&
               item.layer.strokes == layer.strokes &&
               std::equal(beneath.begin(), beneath.end(), item.beneath.begin(), item.beneath.end(),
                          looksTheSame);
    };
    const BandedPicture* known = usedAgain(m_banded.used, m_banded.before, same);
    return known ? std::optional(known->blended) : std::nullopt;
}

void CompositionCache::finish() {
    m_sampled = {{}, std::move(m_sampled.used)};
    m_banded = {{}, std::move(m_banded.used)};
    m_healed = {{}, std::move(m_healed.used)};
    m_lighting = {{}, std::move(m_lighting.used)};
    m_outlines = {{}, std::move(m_outlines.used)};
    m_masks = {{}, std::move(m_masks.used)};
}

} // namespace esm

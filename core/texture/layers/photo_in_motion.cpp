#include "core/texture/layers/photo_in_motion.h"

#include "core/texture/layers/layer_stack.h"
#include "core/texture/layers/multi_band.h"
#include "core/texture/layers/page_painter.h"
#include "core/texture/layers/surface_beneath.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::array<std::uint8_t, 3> allIsLeft{255, 255, 255};

/// Bands are made of differences that pass slowly; followed by this many rays they take a few hundredths of a
/// second.
constexpr int longestSideInMotion = 160;

PhotoSize sizeInMotion(PhotoSize photo) {
    while (std::max(photo.width, photo.height) > longestSideInMotion)
        photo = {(photo.width + 1) / 2, (photo.height + 1) / 2};
    return photo;
}

} // namespace

double borderInMotion(const TextureLayer& layer) {
    const bool isBanded = layer.blending == Blending::MultiBand;
    return isBanded ? std::min(layer.blendPixels, bandedBorder) : layer.blendPixels;
}

TiledPages maskedPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                       const BrushStrokes& strokes, CompositionCache& cache, const Progress& progress) {
    ProgressParts parts(progress);
    const LayerStack mask(mesh, atlas.corners, {paintedMask(strokes)}, allIsLeft, cache, parts.next(0.1));
    TiledPages masked = pages;
    const auto owners = cache.ownersOf(atlas, parts.next(0.4));
    paintAlpha(mask, atlas, *owners, masked, parts.rest());
    return masked;
}

Image bandsInMotion(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                    std::array<std::uint8_t, 3> baseColour, const TextureLayer& layer,
                    CompositionCache& cache, const Progress& progress) {
    ProgressParts parts(progress);
    const SampledPicture picture = cache.sampled(pictureOf(layer));
    const PhotoSize photo = sizeOf(*picture.picture);
    const PhotoPlane plane{layer.projector, photo, sizeInMotion(photo)};
    const std::vector<Patch> patches = patchesIn(plane, mesh);
    const auto query = cache.queryOf(mesh);
    const auto seen = [&](const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> ground) {
        const LayerStack stack(mesh, patches, layers, ground, cache, parts.nextOfRest(0.3));
        return surfaceBeneath(stack, *query, plane, parts.nextOfRest(0.5));
    };
    const Image under = seen(beneath, baseColour);
    const Image mask = layer.strokes.empty() ? Image() : seen({paintedMask(layer.strokes)}, allIsLeft);
    return bandsAddedTo(*picture.sampler, under, mask, layer.blendPixels);
}

} // namespace esm

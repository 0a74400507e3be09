#include "core/texture/layers/surface_match.h"

#include "core/texture/photo/photo_sampler.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int enoughPixels = 512; ///< of the longer side, for means and spreads

} // namespace

/// Prepared as the layer is but for the match itself, since matching what is matched already would find
/// nothing left to do, and for what comes after it: an adjustment is not to be taken back by the match.
std::optional<ColourMatch> matchToSurface(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                                          std::array<std::uint8_t, 3> baseColour, const TextureLayer& layer,
                                          const Progress& progress) {
    PhotoPreparation unmatched = layer.preparation;
    unmatched.match.reset();
    unmatched.adjustment = {};
    ProgressParts parts(progress);
    Image photo = prepared(layer.photo->image, unmatched, parts.next(0.4));
    const PhotoSize whole = sizeOf(photo);
    while (std::max(photo.width, photo.height) > enoughPixels)
        photo = halved(photo);
    const PhotoPlane plane{layer.projector, whole, sizeOf(photo)};
    return matchColours(photo, surfaceBeneath(mesh, beneath, baseColour, plane, parts.rest()));
}

} // namespace esm

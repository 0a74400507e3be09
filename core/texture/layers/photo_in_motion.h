#pragma once

#include "core/texture/layers/composition_cache.h"
#include "core/texture/layers/tiled_pages.h"

/// What the renderer needs to show a photo on the organ without composing it, while its projector moves.
namespace esm {

/// Photo pixels over which a layer's photo fades in from its border.
double borderInMotion(const TextureLayer& layer);

/// The pages with what a photo's strokes leave of it as their alpha: 255 where all is left. Strokes stay
/// where they are on the organ while a projector moves, so this need be done only once.
/// @throws Cancelled
TiledPages maskedPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                       const BrushStrokes& strokes, CompositionCache& cache, const Progress& progress = {});

/// What a photo in motion is drawn on.
struct LaidTexture {
    const TriangleMesh& mesh;
    const Atlas& atlas;
    const TiledPages& pages; ///< without the photo; alpha is what its strokes leave, see `maskedPages`
};

/// What blending in bands adds to a layer's photo, see `bandsAddedTo`, coarse enough to be made for each
/// place of the projector. Bands are then made for what the photo is drawn on, layers above it too, where
/// those of a photo at rest are made for what lies beneath it. Precondition: the layer has a photo.
/// @throws Cancelled
Image bandsInMotion(const LaidTexture& texture, const TextureLayer& layer, CompositionCache& cache,
                    const Progress& progress = {});

} // namespace esm

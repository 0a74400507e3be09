#pragma once

#include "core/texture/layers/composition_cache.h"
#include "core/texture/layers/tiled_pages.h"

#include <array>
#include <vector>

/// What the renderer needs to show a photo on the organ without composing it, while its projector moves.
namespace esm {

/// Photo pixels over which a layer's photo fades in from its border.
double borderInMotion(const TextureLayer& layer);

/// The pages with what a photo's strokes leave of it as their alpha: 255 where all is left. Strokes stay
/// where they are on the organ while a projector moves, so this need be done only once.
/// @throws Cancelled
TiledPages maskedPages(const TriangleMesh& mesh, const Atlas& atlas, const TiledPages& pages,
                       const BrushStrokes& strokes, CompositionCache& cache, const Progress& progress = {});

/// What blending in bands adds to a layer's photo, see `bandsAddedTo`, coarse enough to be made for each
/// place of the projector. Precondition: the layer has a photo.
/// @param beneath from the lowest to the topmost: those below the layer
/// @throws Cancelled
Image bandsInMotion(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                    std::array<std::uint8_t, 3> baseColour, const TextureLayer& layer,
                    CompositionCache& cache, const Progress& progress = {});

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/layers/composition_cache.h"
#include "core/texture/layers/texture_layer.h"
#include "core/texture/layers/tiled_pages.h"

#include <array>
#include <vector>

namespace esm {

/// Lays the layers over the base colour, from the first to the last, by scanning every patch from the surface
/// [R 4.3.2.3]: mixes what lies beneath with what the layer's blending makes of it and the layer's colour, by
/// opacity × mask × border × alpha, in sRGB values [R 4.3.3]. Pure: the same input
/// gives the same pages, whatever the number of threads. Texels around the patches are filled with the
/// patches' colours, so that filtering shows no dark seams.
/// @throws InvalidModel for a layout of another surface or beyond its pages; Cancelled
std::vector<Image> composite(const TriangleMesh& mesh, const Atlas& atlas,
                             const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                             const Progress& progress = {});

/// The same, with what a composition of the surface before left.
std::vector<Image> composite(const TriangleMesh& mesh, const Atlas& atlas,
                             const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                             CompositionCache& cache, const Progress& progress = {});

/// The same with 16 bits a channel: what lies between two colours of 8 bits is kept.
std::vector<DeepImage> compositeDeep(const TriangleMesh& mesh, const Atlas& atlas,
                                     const std::vector<TextureLayer>& layers,
                                     std::array<std::uint8_t, 3> baseColour, CompositionCache& cache,
                                     const Progress& progress = {});

/// What was composed before for the same surface and atlas.
struct Composition {
    std::vector<TextureLayer> layers;
    std::array<std::uint8_t, 3> baseColour{};
    std::shared_ptr<const TiledPages> pages; ///< null before anything was composed
};

/// The pages that composite() makes, bit by bit, but only what changed is composed: the triangles that a
/// changed layer reaches before or after. Tiles in which nothing changed are those before. Takes what
/// composite() takes.
TiledPages recomposite(const TriangleMesh& mesh, const Atlas& atlas, const Composition& before,
                       const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                       CompositionCache& cache, const Progress& progress = {});

/// What one layer covers.
struct LayerCoverage {
    std::size_t texels = 0;    ///< texels inside a patch to which the layer gives a weight that can be seen
    std::size_t triangles = 0; ///< triangles whose patch touches a texel with such a weight
};
/// @throws InvalidModel as composite() does
LayerCoverage coverage(const TriangleMesh& mesh, const Atlas& atlas, const TextureLayer& layer);

/// The largest difference of colour (0 to 255) across any edge that two triangles share, compared at points
/// along the edge with bilinear filtering.
double seamError(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages);

/// The same in the pages halved so often, 1 for `smallerPages`'s first, as the renderer reads them: by
/// `levelInset` within each patch. @param pages one per page, all of that level
double seamError(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<Image>& pages, int halvings);

} // namespace esm

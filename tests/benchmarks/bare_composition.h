#pragma once

#include "core/texture/atlas/atlas.h"
#include "core/texture/layers/texture_layer.h"

namespace benchmarks {

/// A photo with its halved pictures, the first being the photo itself.
using BarePyramid = std::vector<esm::Image>;
BarePyramid barePyramid(const esm::Image& photo);

/// Lays a parallel photo on a page of an atlas by a plain scalar loop over the texels inside each triangle
/// that faces it: place in the photo, weight at its border, bilinear reading in two sizes, mixing. It follows
/// no rays, knows no alpha and fills nothing around the patches.
void layBare(const esm::TriangleMesh& mesh, const esm::Atlas& atlas, const esm::TextureLayer& layer,
             const BarePyramid& photo, esm::Image& page);

} // namespace benchmarks

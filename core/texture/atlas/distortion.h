#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/texture/atlas/atlas.h"
#include "core/texture/atlas/stretch.h"

namespace esm {

/// How a layout stretches the surface. Triangles without an area on the surface do not count; without any
/// that does all is 1.
struct Distortion {
    DistortionSpread angle, area; ///< `angleSpread()`, `areaSpread()`
    std::size_t flipped = 0;      ///< triangles that lie mirrored against most of their patch's area
    std::size_t collapsed = 0;    ///< triangles with an area on the surface and none in the page; not in the
                                  ///< spreads
};

Distortion distortionOf(const TriangleMesh& mesh, const Atlas& atlas);

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/layers/texture_layer.h"

#include <array>
#include <vector>

namespace esm {

class LayerStack;
class SurfaceQuery;

/// The plane of a photo, seen in a picture of any size.
struct PhotoPlane {
    Projector projector;
    PhotoSize photo;   ///< in whose pixels the projector counts
    PhotoSize picture; ///< pixels that are asked for; the whole photo in them, each dimension > 0
};

/// What layers make of a surface as a projector sees it: the picture that the photo would be if it showed the
/// same. A pixel is a ray through its middle, and alpha is 0 where it meets no surface that takes the
/// projector's colour. Pure: the same with any number of threads.
/// @param beneath from the lowest to the topmost: those below the layer whose projector it is
/// @throws Cancelled
Image surfaceBeneath(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                     std::array<std::uint8_t, 3> baseColour, const PhotoPlane& plane,
                     const Progress& progress = {});

/// Each triangle's place in the plane's picture, pixels; all corners 0 where the eye does not see all of
/// them.
std::vector<std::array<Eigen::Vector2d, 3>> patchesIn(const PhotoPlane& plane, const TriangleMesh& mesh);

/// The same of a stack whose patches are those in the plane.
Image surfaceBeneath(const LayerStack& stack, const SurfaceQuery& query, const PhotoPlane& plane,
                     const Progress& progress = {});

} // namespace esm

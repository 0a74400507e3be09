#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/lit_triangles.h"

#include <Eigen/Geometry>

#include <vector>

namespace esm {

/// How much of a photo is left near the outlines that its projector sees, on a grid over the photo. Without
/// nodes nothing fades.
struct OutlineFeather {
    double spacing = 1;        ///< photo pixels between two nodes, the first at the top left corner
    int columns = 0, rows = 0; ///< nodes
    std::vector<float> faded;  ///< 0 (all is left) to 1, row by row

    /// 0 to 1 at a place of the photo, pixels. Precondition: it lies within the photo.
    double weightAt(double x, double y) const;
    /// Whether the weight is 1 at each place of a box, pixels.
    bool isClear(const Eigen::AlignedBox2d& box) const;
};

/// Fades a photo out towards every outline over `blendPixels`, from either side: there the surface turns away
/// or ends before other surface, and the photo would end with a step along the edges of triangles.
/// @throws Cancelled
OutlineFeather outlineFeather(const ShadowCaster& surface, const SurfaceQuery& query,
                              const Projector& projector, PhotoSize photo, double blendPixels,
                              const Progress& progress = {});

} // namespace esm

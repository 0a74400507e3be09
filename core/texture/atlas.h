#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <vector>

namespace esm {

struct AtlasOptions {
    int size = 2048; ///< pixels, width and height of a page
    int pages = 1;
    int gap = 2; ///< pixels that stay free between any two patches
};

/// Where every triangle lies in texture space: one patch each, similar to its 3-D shape, one scale for all
/// [R 4.3.2]. A degenerate triangle has a defined place without area.
struct Atlas {
    AtlasOptions options;
    double texelsPerMetre = 0;
    double utilisation = 0; ///< area of the patches over the area of the pages
    std::vector<std::array<Eigen::Vector2d, 3>>
        corners;                     ///< per triangle, pixels from the page's top left corner
    std::vector<std::uint16_t> page; ///< per triangle
};

/// The source's rows of triangles [R 4.3.2.2]. @throws InvalidModel when size, pages or gap cannot hold the
/// mesh, naming the smallest size that can
Atlas packAtlas(const TriangleMesh& mesh, const AtlasOptions& options);

} // namespace esm

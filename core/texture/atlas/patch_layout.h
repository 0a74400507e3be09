#pragma once

#include "core/texture/atlas/patch_row.h"

#include <cstdint>
#include <vector>

namespace esm {

/// Where patches came to lie at one scale.
struct PatchLayout {
    int pages = 0;                     ///< used; 0 when a patch exceeds a page, and all else empty
    double height = 0;                 ///< pixels that all patches take, one page after the other
    std::vector<PatchCorners> corners; ///< per triangle, in the order in which they were given
    std::vector<std::uint16_t> page;   ///< per triangle
};

struct PageRoom {
    double size; ///< pixels, width and height
    double gap;  ///< pixels between any two patches; half of it stays free at the borders
};

} // namespace esm

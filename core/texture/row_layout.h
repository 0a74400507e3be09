#pragma once

#include "core/texture/patch_row.h"

namespace esm {

struct RowLayout {
    int pages = 0;                     ///< pages used; 0 when a patch exceeds a page, and all else empty
    double height = 0;                 ///< pixels that all rows take, one page after the other
    std::vector<PatchCorners> corners; ///< per shape
    std::vector<std::uint16_t> page;   ///< per shape
};

struct RowPage {
    double size; ///< pixels, width and height
    double gap;  ///< pixels between any two patches; half of it stays free at the borders
};

/// Whether each of the shapes has room on a page, though perhaps no two of them.
bool fitOnAPage(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page);

/// Rows of triangles with the third corner alternately up and down [R 4.3.2.2]. The shapes come tallest
/// first, so that a row's height is known when it starts. Every patch keeps the gap to all others, not just
/// to the one before.
RowLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page);

} // namespace esm

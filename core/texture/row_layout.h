#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace esm {

/// A triangle laid on its longest side [R fig. 4.8]: that side from (0, 0) to (base, 0), the third corner at
/// (foot, height), counter-clockwise with y up, m. A degenerate triangle is a point: all three are 0.
struct PatchShape {
    double base = 0, foot = 0, height = 0;
    std::uint32_t triangle = 0;
    std::uint8_t firstCorner = 0; ///< the triangle's corner that lies at (0, 0)
};

using PatchCorners = std::array<Eigen::Vector2d, 3>; ///< in the shape's order, pixels, y down

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

/// Rows of triangles with the third corner alternately up and down [R 4.3.2.2]. The shapes come tallest
/// first, so that a row's height is known when it starts. Every patch keeps the gap to all others, not just
/// to the one before.
RowLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page);

/// The smallest shift to the right after which `moving`, which comes in from the right, keeps `gap` to
/// `placed`. Minus infinity when the two pass above each other.
double clearingShift(const PatchCorners& placed, const PatchCorners& moving, double gap);

} // namespace esm

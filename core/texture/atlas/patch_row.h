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

/// How a patch stands in a row.
struct PatchStance {
    bool pointsUp = true;    ///< the third corner
    bool isMirrored = false; ///< left and right change places
};

/// The patch in a row whose upper border is y = 0, its leftmost corner at x = 0. A base lies on the row's
/// border.
PatchCorners cornersInRow(const PatchShape& shape, double texelsPerMetre, double rowHeight,
                          const PatchStance& stance);

double rightEnd(const PatchCorners& corners);
void shift(PatchCorners& corners, double x, double y);

/// The smallest shift to the right after which `moving`, which comes in from the right, keeps `gap` to
/// `placed`. Minus infinity when the two pass above each other.
double clearingShift(const PatchCorners& placed, const PatchCorners& moving, double gap);

/// The patches of a row that is being filled from the left, each at a gap from all others.
class PatchRow {
public:
    bool isEmpty() const { return m_patches.empty(); }
    /// The smallest shift of at least `start` that leaves the gap to every patch. Precondition: the leftmost
    /// corner is at x = 0.
    double shiftFor(const PatchCorners& moving, double start, double gap) const;
    void add(const PatchCorners& corners);
    void clear();

private:
    std::vector<PatchCorners> m_patches;
    /// The right end of the first i + 1 patches: once that lies a gap to the left of a new patch, no earlier
    /// patch can be near it.
    std::vector<double> m_reach;
};

} // namespace esm

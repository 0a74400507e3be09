#pragma once

#include "core/geometry/border_search.h"

#include <vector>

namespace esm {

/// A place on a border: `along` of the edge from a corner to the next, 0 to 1; the corner itself at 0.
struct BorderPlace {
    std::uint32_t corner = noIndex;
    double along = 0;

    bool isCorner() const { return along == 0; }
};

/// Two places that become one. At least one is a corner.
struct PlacePair {
    BorderPlace one, other;
};

/// Stretches of two borders that lie across from each other, one of them followed backwards: pairs from its
/// one end to the other.
using SlitStretch = std::vector<PlacePair>;

/// Position of a place on a border.
Eigen::Vector3d positionOf(const BorderPlace& place, const BorderCorners& corners,
                           const std::vector<Eigen::Vector3d>& vertices);

/// All stretches that may be stitched where the borders are no farther apart than `width`. Those that follow
/// each other share a pair.
std::vector<SlitStretch> slitStretches(const std::vector<Eigen::Vector3d>& vertices,
                                       const BorderCorners& corners, double width);

} // namespace esm

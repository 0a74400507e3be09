#pragma once

#include "core/samples/tissue_picture.h"

namespace esm {

/// A vessel tree drawn into a field: 1 where a vessel covers the pixel. Starts at a place with a direction
/// (radians) and a radius, all in pixels; thins out, winds and branches until it is a hair. The same seed
/// draws the same tree.
struct VesselRoot {
    Eigen::Vector2d place;
    double direction;
    double radius;
    std::uint32_t seed;
};
void drawVesselTree(Field& cover, const VesselRoot& root);

} // namespace esm

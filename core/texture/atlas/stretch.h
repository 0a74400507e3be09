#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace esm {

/// How a triangle of the surface lies in the plane. The map from one to the other is linear; it stretches one
/// direction most, by its larger singular value, and the direction at right angles least, by its smaller one
/// (Sander, Snyder, Gortler and Hoppe 2001, Texture mapping progressive meshes; Hormann and Greiner 2000,
/// MIPS: an efficient global parametrization method).
struct Stretch {
    double larger = 0, smaller = 0; ///< singular values; 0 of a triangle without area here or there
    double area = 0;                ///< on the surface; 0 of a triangle without area there
    bool isClockwise = false;       ///< seen with y up, where it is counter-clockwise on the surface
};

Stretch stretchOf(const std::array<Eigen::Vector3d, 3>& surface, const std::array<Eigen::Vector2d, 3>& plane);

/// A measure of how much triangles are distorted, 1 where they are not, over all of them by their areas on
/// the surface.
struct DistortionSpread {
    double mean = 1;
    double percentile95 = 1; ///< that 95 % of the area does not exceed
    double worst = 1;
};

/// Of the larger singular value over the smaller one: 1 where angles are kept.
DistortionSpread angleSpread(const std::vector<Stretch>& stretches);

/// Of each triangle's area in the plane per area on the surface against the mean of all, the larger over the
/// smaller.
DistortionSpread areaSpread(const std::vector<Stretch>& stretches);

} // namespace esm

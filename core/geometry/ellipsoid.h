#pragma once

#include "core/support/fields.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace esm {

/// A free ellipsoid that marks a region of an organ [R 2.3.7].
struct Ellipsoid {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< m
    Eigen::Vector3d radii = Eigen::Vector3d::Ones();  ///< m, along the ellipsoid's own axes, each > 0
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity(); ///< own axes → model

    bool operator==(const Ellipsoid&) const = default;
};
template<>
inline constexpr auto fieldsOf<Ellipsoid> =
    fieldTable(field("centre", &Ellipsoid::centre, finiteLimits("the centre")),
               field("radii", &Ellipsoid::radii, positiveLimits("the three radii", "m")),
               field("orientation", &Ellipsoid::orientation).mayBeAbsent());

/// True for points inside or on the surface.
bool contains(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point);

/// Distance to the nearest point of the surface, m, exact but for rounding (about 10⁻¹⁵ of the size); 0
/// inside and on the surface. Along any ray that leaves the ellipsoid it rises steadily, as from every convex
/// body.
double distanceOutside(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point);

/// Every problem: places that are not finite, radii not above zero, an orientation that is no rotation.
std::vector<std::string> validate(const Ellipsoid& ellipsoid);

} // namespace esm

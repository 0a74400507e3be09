#pragma once

#include "core/support/fields.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <variant>

namespace esm {

/// What lies within a radius of the origin.
struct Sphere {
    double radius = 0; ///< m
    bool operator==(const Sphere&) const = default;
};
template<>
inline constexpr auto fieldsOf<Sphere> = fieldTable(field("radius", &Sphere::radius,
                                                          positiveLimits("the radius", "m")));

/// What lies within a radius of a segment along z, whose middle is the origin.
struct Capsule {
    double radius = 0; ///< m
    double length = 0; ///< m, of the segment: between the centres of both round ends
    bool operator==(const Capsule&) const = default;
};
template<>
inline constexpr auto
    fieldsOf<Capsule> = fieldTable(field("radius", &Capsule::radius, positiveLimits("the radius", "m")),
                                   field("length", &Capsule::length, amountLimits("the length", "m")));

/// A rigid shape that pushes tissue, in coordinates of its own.
using Collider = std::variant<Sphere, Capsule>;

double radiusOf(const Collider& collider); ///< m
double lengthOf(const Collider& collider); ///< m; 0 of a sphere

/// Its size times a factor.
Collider scaled(Collider collider, double factor);

/// Where a rigid shape stands, and how it is turned.
struct ColliderPose {
    Eigen::Vector3d place; ///< m, of its origin
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

    bool operator==(const ColliderPose&) const = default;
};

/// Part of the way, 0 to 1, from one pose to another: straight on, and turned evenly the shorter way round.
ColliderPose between(const ColliderPose& from, const ColliderPose& to, double part);

struct PlacedCollider {
    Collider shape;
    ColliderPose pose;

    bool operator==(const PlacedCollider&) const = default;
};
PlacedCollider sphereAt(const Eigen::Vector3d& centre, double radius);

/// The segment around which a collider lies; of a sphere, or a capsule without length, a point.
struct ColliderAxis {
    Eigen::Vector3d middle;    ///< m
    Eigen::Vector3d direction; ///< of length 1
    double half;               ///< m, from the middle to either end

    bool isPoint() const { return half == 0; }
    Eigen::Vector3d at(double along) const { return isPoint() ? middle : middle + along * direction; }
    /// m from the middle, without an end.
    double foot(const Eigen::Vector3d& point) const { return (point - middle).dot(direction); }
    /// m from the middle, of the axis' point that is nearest.
    double nearest(const Eigen::Vector3d& point) const {
        return isPoint() ? 0 : std::clamp(foot(point), -half, half);
    }
};
ColliderAxis axisOf(const PlacedCollider& collider);

/// m that some point of the axis goes at most, when the collider moves evenly from one pose to another. Turns
/// about the axis do not move it.
double mostMotion(const Collider& collider, const ColliderPose& from, const ColliderPose& to);

} // namespace esm

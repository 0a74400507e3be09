#include "core/geometry/collider.h"

#include <cmath>

namespace esm {

namespace {

/// m that the ends of an axis go while it turns evenly. Each goes round the axis of the turn, on a circle as
/// wide as the end is far from it. Of the two angles that make the same turn the smaller one is gone through,
/// as between() does.
double arcOf(double half, const ColliderPose& from, const ColliderPose& to) {
    const Eigen::Vector3d direction = from.orientation * Eigen::Vector3d::UnitZ();
    const Eigen::AngleAxisd turn(to.orientation * from.orientation.conjugate());
    const double angle = std::min(std::abs(turn.angle()), 2 * M_PI - std::abs(turn.angle()));
    return half * angle * turn.axis().cross(direction).norm();
}

} // namespace

double radiusOf(const Collider& collider) {
    return std::visit([](const auto& shape) { return shape.radius; }, collider);
}

double lengthOf(const Collider& collider) {
    const auto* capsule = std::get_if<Capsule>(&collider);
    return capsule ? capsule->length : 0;
}

Collider scaled(Collider collider, double factor) {
    std::visit([factor](auto& shape) { shape.radius *= factor; }, collider);
    if (auto* capsule = std::get_if<Capsule>(&collider)) capsule->length *= factor;
    return collider;
}

// Place and turning are mixed apart, each evenly: the turning by spherical interpolation (Shoemake 1985), so
// that an instrument does not turn faster half-way.
ColliderPose between(const ColliderPose& from, const ColliderPose& to, double part) {
    return {from.place + part * (to.place - from.place), from.orientation.slerp(part, to.orientation)};
}

PlacedCollider sphereAt(const Eigen::Vector3d& centre, double radius) {
    return {Sphere{radius}, {centre}};
}

ColliderAxis axisOf(const PlacedCollider& collider) {
    const double half = lengthOf(collider.shape) / 2;
    if (half == 0) return {collider.pose.place, Eigen::Vector3d::UnitZ(), 0};
    return {collider.pose.place, collider.pose.orientation * Eigen::Vector3d::UnitZ(), half};
}

// Shift and arc are added, though they may run against each other. A bound may be too large, and the exact
// way of the farthest point would have to be searched for.
double mostMotion(const Collider& collider, const ColliderPose& from, const ColliderPose& to) {
    const double half = lengthOf(collider) / 2, shift = (to.place - from.place).norm();
    return half == 0 ? shift : shift + arcOf(half, from, to);
}

} // namespace esm

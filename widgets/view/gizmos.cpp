#include "widgets/view/gizmos.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double smallestShare = 0.02; // of its size before: an axis cannot be drawn shut
constexpr double grazing = 1e-3;       // sine of the angle below which a ray runs along a plane

DragPlane photoPlane(const Projector& projector) {
    return {projector.pose.translation(), projector.pose.linear().col(2)};
}

} // namespace

std::optional<Vector3d> meet(const Ray& ray, const DragPlane& plane) {
    const Vector3d direction = ray.direction.normalized();
    const double approach = direction.dot(plane.normal.normalized());
    if (std::abs(approach) < grazing) return std::nullopt;
    const double distance = (plane.point - ray.origin).dot(plane.normal.normalized()) / approach;
    if (!(distance > 0)) return std::nullopt;
    return ray.origin + distance * direction;
}

std::optional<double> distanceTo(const Ellipsoid& ellipsoid, const Ray& ray) {
    // In the space where the ellipsoid is the unit sphere: |origin + t·direction| = 1.
    const auto toUnit = [&](const Vector3d& v) {
        return Vector3d((ellipsoid.orientation.inverse() * v).cwiseQuotient(ellipsoid.radii));
    };
    const Vector3d origin = toUnit(ray.origin - ellipsoid.centre);
    const Vector3d direction = toUnit(ray.direction.normalized());
    const double a = direction.squaredNorm(), b = origin.dot(direction), c = origin.squaredNorm() - 1;
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || c < 0 || b > 0) return std::nullopt;
    return (-b - std::sqrt(discriminant)) / a;
}

std::optional<double> distanceTo(const Projector& projector, const Ray& ray) {
    const std::optional<Vector3d> point = meet(ray, photoPlane(projector));
    if (!point) return std::nullopt;
    const Vector3d local = projector.pose.inverse() * *point;
    if (std::abs(local.x()) > projector.width / 2 || std::abs(local.y()) > projector.height / 2)
        return std::nullopt;
    return (*point - ray.origin).norm();
}

std::array<Vector3d, 6> handles(const Ellipsoid& ellipsoid) {
    std::array<Vector3d, 6> ends;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto axis = static_cast<Eigen::Index>(i / 2);
        const double side = i % 2 == 0 ? 1 : -1;
        ends[i] = ellipsoid.centre +
                  ellipsoid.orientation * Vector3d(side * ellipsoid.radii[axis] * Vector3d::Unit(axis));
    }
    return ends;
}

std::array<Vector3d, 4> handles(const Projector& projector) {
    const double x = projector.width / 2, y = projector.height / 2;
    return {projector.pose * Vector3d(-x, -y, 0), projector.pose * Vector3d(x, -y, 0),
            projector.pose * Vector3d(x, y, 0), projector.pose * Vector3d(-x, y, 0)};
}

Ellipsoid scaled(const Ellipsoid& ellipsoid, std::size_t handle, const Ray& ray) {
    const auto axis = static_cast<Eigen::Index>(handle / 2);
    const Vector3d along = ellipsoid.orientation * Vector3d::Unit(axis) * (handle % 2 == 0 ? 1.0 : -1.0);
    const Vector3d direction = ray.direction.normalized();
    // The point of the axis nearest to the ray.
    const Vector3d offset = ray.origin - ellipsoid.centre;
    const double slant = along.dot(direction);
    const double sine = 1 - slant * slant;
    if (sine < grazing) return ellipsoid;
    const double length = (along.dot(offset) - slant * direction.dot(offset)) / sine;
    Ellipsoid result = ellipsoid;
    result.radii[axis] = std::max(length, smallestShare * ellipsoid.radii[axis]);
    return result;
}

Projector scaled(const Projector& projector, const Ray& ray, Proportions proportions) {
    const std::optional<Vector3d> point = meet(ray, photoPlane(projector));
    if (!point) return projector;
    const Vector3d local = projector.pose.inverse() * *point;
    double wider = 2 * std::abs(local.x()) / projector.width,
           higher = 2 * std::abs(local.y()) / projector.height;
    if (proportions == Proportions::Kept) {
        const double widthSquared = projector.width * projector.width;
        const double heightSquared = projector.height * projector.height;
        wider = higher = (wider * widthSquared + higher * heightSquared) / (widthSquared + heightSquared);
    }
    Projector result = projector;
    result.width *= std::max(wider, smallestShare);
    result.height *= std::max(higher, smallestShare);
    return result;
}

} // namespace esm

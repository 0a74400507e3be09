#include "widgets/view/gizmos.h"

#include "core/support/angles.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double smallestShare = 0.02; // of its size before: an axis cannot be drawn shut
constexpr double grazing = 1e-3;       // sine of the angle below which a ray runs along a plane

DragPlane photoPlane(const PhotoFace& photo) {
    const Eigen::Isometry3d& pose = photo.projector.pose;
    return {pose * Vector3d(0, 0, -photo.depth), pose.linear().col(2)};
}

/// Lower and upper corner in the projector's own space, m.
Eigen::AlignedBox2d ownBox(const PhotoFace& photo) {
    const auto corners = photoCorners(photo.projector, photo.size, photo.depth);
    const Eigen::Isometry3d toOwn = photo.projector.pose.inverse();
    return {Eigen::Vector2d((toOwn * corners[0]).head<2>()), Eigen::Vector2d((toOwn * corners[2]).head<2>())};
}

/// How much wider and higher a photo becomes, by where the ray points on its plane.
struct Growth {
    double wider, higher;
};

/// From the place that stays to a border and to the pointer, m, along width and height.
struct Arms {
    Eigen::Vector2d border, pointer;
};

/// From the line of sight to the drawn border; a part of the size where that lies outside the photo.
Arms armsFromSight(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& point) {
    Arms arms{{}, point.cwiseAbs()};
    for (const Eigen::Index axis : {0, 1}) {
        const double border = std::abs(point[axis] < 0 ? box.min()[axis] : box.max()[axis]);
        arms.border[axis] = std::max(border, 0.05 * box.sizes()[axis]);
    }
    return arms;
}

/// To which side of the photo's middle a handle lies, −1, 0 or 1 along width and height.
Eigen::Vector2d sideOf(std::size_t handle) {
    constexpr std::array<std::array<int, 2>, photoHandles> sides{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return {sides[handle][0], sides[handle][1]};
}

/// From the side or corner opposite to a handle. A pointer beyond it asks for nothing.
Arms armsFromOpposite(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& point, std::size_t handle) {
    const Eigen::Vector2d side = sideOf(handle), half = box.sizes() / 2;
    const Eigen::Vector2d pointer = half + side.cwiseProduct(point - box.center());
    return {box.sizes(), pointer.cwiseMax(0)};
}

/// Of a corner that keeps proportions, the growth of both sides is their mean weighted by the squares of
/// their lengths: the place on the diagonal that is nearest to the pointer. An edge changes its own direction
/// alone.
Growth growthOf(const Arms& arms, std::size_t handle, bool kept) {
    const double width = arms.border.x(), height = arms.border.y();
    Growth growth{arms.pointer.x() / width, arms.pointer.y() / height};
    const bool isEdge = handle >= 4, isAcross = handle % 2 == 1;
    if (isEdge) {
        const double along = isAcross ? growth.wider : growth.higher;
        growth = kept ? Growth{along, along} : isAcross ? Growth{along, 1} : Growth{1, along};
    } else if (kept) {
        growth.wider = growth.higher = (growth.wider * width * width + growth.higher * height * height) /
                                       (width * width + height * height);
    }
    return {std::max(growth.wider, smallestShare), std::max(growth.higher, smallestShare)};
}

/// A perspective photo lies at a given depth, so it becomes wider by a shorter focal length or a wider field
/// of view, whose tangent is what grows.
void grow(Projector& projector, const Growth& growth) {
    if (projector.kind == ProjectorKind::Parallel) {
        projector.width *= growth.wider;
        projector.height *= growth.higher;
    } else if (projector.intrinsics) {
        projector.intrinsics->fx /= growth.wider;
        projector.intrinsics->fy /= growth.higher;
    } else {
        const double slope = growth.higher * std::tan(toRadians(projector.fieldOfView) / 2);
        projector.fieldOfView = std::clamp(toDegrees(2 * std::atan(slope)), texture_limits::narrowestView,
                                           texture_limits::widestView);
    }
}

} // namespace

/// A ray along the plane would meet it kilometres away, and a hand that trembles would send there what it
/// drags: below a thousandth there is no answer.
std::optional<Vector3d> meet(const Ray& ray, const DragPlane& plane) {
    const Vector3d direction = ray.direction.normalized();
    const double approach = direction.dot(plane.normal.normalized());
    if (std::abs(approach) < grazing) return std::nullopt;
    const double distance = (plane.point - ray.origin).dot(plane.normal.normalized()) / approach;
    if (!(distance > 0)) return std::nullopt;
    return ray.origin + distance * direction;
}

/// From outside and ahead alone: c < 0 is an eye within the ellipsoid, b > 0 one that looks away from it.
/// Nobody wants to take hold of what surrounds them.
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

std::optional<double> distanceTo(const PhotoFace& photo, const Ray& ray) {
    const std::optional<Vector3d> point = meet(ray, photoPlane(photo));
    if (!point) return std::nullopt;
    const Vector3d local = photo.projector.pose.inverse() * *point;
    if (!ownBox(photo).contains(Eigen::Vector2d(local.head<2>()))) return std::nullopt;
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

std::array<Vector3d, photoHandles> handles(const PhotoFace& photo) {
    const auto corners = photoCorners(photo.projector, photo.size, photo.depth);
    std::array<Vector3d, photoHandles> places;
    for (std::size_t i = 0; i < 4; ++i) {
        places[i] = corners[i];
        places[4 + i] = (corners[i] + corners[(i + 1) % 4]) / 2;
    }
    return places;
}

/// The axis and the line of sight are two lines in space that hardly ever meet. The handle goes to the point
/// of the axis that is nearest to the ray; where both run alike that point is not determined, and nothing
/// changes.
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

/// The middle goes half of the way that the drawn side goes, so that the opposite one stays.
Projector scaled(const PhotoFace& photo, std::size_t handle, const Ray& ray, const Scaling& scaling) {
    const std::optional<Vector3d> point = meet(ray, photoPlane(photo));
    if (!point) return photo.projector;
    const Eigen::Vector2d local = (photo.projector.pose.inverse() * *point).head<2>();
    const bool isParallel = photo.projector.kind == ProjectorKind::Parallel;
    const bool hasOneFreedom = !isParallel && !photo.projector.intrinsics;
    const bool kept = hasOneFreedom || (handle < 4 && scaling.proportions == Proportions::Kept);
    const bool staysOpposite = isParallel && scaling.stays == Stays::OtherSide;
    const Eigen::AlignedBox2d box = ownBox(photo);
    Projector result = photo.projector;
    grow(result, growthOf(staysOpposite ? armsFromOpposite(box, local, handle) : armsFromSight(box, local),
                          handle, kept));
    if (staysOpposite) {
        const Eigen::Vector2d grown(result.width - box.sizes().x(), result.height - box.sizes().y());
        const Eigen::Vector2d shift = sideOf(handle).cwiseProduct(grown) / 2;
        result.pose.translate(Vector3d(shift.x(), shift.y(), 0));
    }
    return result;
}

} // namespace esm

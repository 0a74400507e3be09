#pragma once

#include "core/geometry/ellipsoid.h"
#include "core/geometry/surface_query.h"
#include "core/texture/projector.h"

#include <array>
#include <optional>

namespace esm {

/// A plane that the mouse moves in: through a point, with a normal.
struct DragPlane {
    Eigen::Vector3d point; ///< m
    Eigen::Vector3d normal;
};

/// Where a ray meets a plane; nothing when it runs along it or the plane lies behind.
std::optional<Eigen::Vector3d> meet(const Ray& ray, const DragPlane& plane);

/// Distance along the ray to an ellipsoid, m; nothing when it misses or begins inside.
std::optional<double> distanceTo(const Ellipsoid& ellipsoid, const Ray& ray);
/// Distance along the ray to a projector's photo, m.
std::optional<double> distanceTo(const Projector& projector, const Ray& ray);

/// The ends of an ellipsoid's axes: +x, −x, +y, −y, +z, −z.
std::array<Eigen::Vector3d, 6> handles(const Ellipsoid& ellipsoid);
/// A photo's corners: bottom left, bottom right, top right, top left.
std::array<Eigen::Vector3d, 4> handles(const Projector& projector);

/// The ellipsoid with one axis as long as the ray asks for; its centre stays. `handle` counts as in
/// `handles`.
Ellipsoid scaled(const Ellipsoid& ellipsoid, std::size_t handle, const Ray& ray);
enum class Proportions { Kept, Free };

/// The projector with a corner drawn to the ray; its centre stays. With its proportions kept, the corner goes
/// along its diagonal to where it is nearest to the point that the ray points at; else to that point, width
/// and height each on its own.
Projector scaled(const Projector& projector, const Ray& ray, Proportions proportions);

} // namespace esm

#pragma once

#include "core/geometry/ellipsoid.h"
#include "core/geometry/triangle_mesh.h"

namespace esm {

/// A place on a surface, and which way is out.
struct SurfaceSpot {
    Eigen::Vector3d point;   ///< m
    Eigen::Vector3d outward; ///< of length 1
};

/// The mean direction in which the surface faces within `radius` (m) of a spot, by area; what faces away from
/// the spot's own direction, an opposite wall, does not count.
Eigen::Vector3d outwardAround(const TriangleMesh& mesh, const SurfaceSpot& spot, double radius);

/// An ellipsoid of these radii (m) around a spot, its own z axis as the surface under it faces.
Ellipsoid laidOn(const TriangleMesh& mesh, const SurfaceSpot& spot, const Eigen::Vector3d& radii);

} // namespace esm

#pragma once

#include "core/geometry/ellipsoid.h"
#include "core/surface/surface_query.h"
#include "core/texture/projection/projector.h"

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

/// A projector's photo where it is shown: see `shownDepth`.
struct PhotoFace {
    Projector projector;
    PhotoSize size{1, 1};
    double depth = 0; ///< m
};

/// Distance along the ray to an ellipsoid, m; nothing when it misses or begins inside.
std::optional<double> distanceTo(const Ellipsoid& ellipsoid, const Ray& ray);
/// Distance along the ray to a projector's photo, m.
std::optional<double> distanceTo(const PhotoFace& photo, const Ray& ray);

/// The ends of an ellipsoid's axes: +x, −x, +y, −y, +z, −z.
std::array<Eigen::Vector3d, 6> handles(const Ellipsoid& ellipsoid);
/// A photo's corners, bottom left, bottom right, top right, top left; then the middles of its edges, bottom,
/// right, top, left.
constexpr std::size_t photoHandles = 8;
std::array<Eigen::Vector3d, photoHandles> handles(const PhotoFace& photo);

/// The ellipsoid with one axis as long as the ray asks for; its centre stays. `handle` counts as in
/// `handles`.
Ellipsoid scaled(const Ellipsoid& ellipsoid, std::size_t handle, const Ray& ray);
enum class Proportions { Kept, Free };
enum class Stays { OtherSide, Middle };

/// How a photo is scaled by a handle.
struct Scaling {
    Proportions proportions = Proportions::Kept;
    Stays stays = Stays::OtherSide; ///< of a parallel projector
};

/// The projector with a handle drawn to the ray. A corner whose proportions are kept goes along its diagonal
/// to where it is nearest to the point that the ray points at; else to that point, width and height each on
/// its own. The middle of an edge changes only the width or the height. Of a perspective projector the eye
/// and the line of sight stay whatever is asked for; a field of view has one freedom: all of its handles keep
/// the proportions.
Projector scaled(const PhotoFace& photo, std::size_t handle, const Ray& ray, const Scaling& scaling);

} // namespace esm

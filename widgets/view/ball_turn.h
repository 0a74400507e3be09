#pragma once

#include "core/surface/surface_query.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace esm {

/// A handle taken hold of, by the ray through the mouse.
struct Grip {
    Eigen::Vector3d place; ///< m, of the handle
    Ray ray;
};

/// The shortest turn about a centre between where two rays meet the ball on which the handle goes round: the
/// grip's and the present one. Where a ray misses the ball, its edge is met. The ball is turned at its back
/// where the handle is clearly behind the centre, else at its front.
Eigen::Quaterniond ballTurn(const Eigen::Vector3d& centre, const Grip& grip, const Ray& ray);

} // namespace esm

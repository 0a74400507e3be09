#include "widgets/view/ball_turn.h"

#include "core/geometry/shortest_turn.h"

#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

struct Ball {
    Vector3d centre; ///< m
    double radius;   ///< m
    double side;     ///< along the ray: −1 where it comes in, 1 where it leaves
};

/// From the ball's centre to where a ray meets its side, else towards where the ray passes nearest. At the
/// outline both are the same, so that nothing jumps there.
Vector3d met(const Ball& ball, const Ray& ray) {
    const Vector3d direction = ray.direction.normalized(), start = ray.origin - ball.centre;
    const Vector3d nearest = start - start.dot(direction) * direction;
    const double depth = ball.radius * ball.radius - nearest.squaredNorm();
    return depth > 0 ? Vector3d(nearest + ball.side * std::sqrt(depth) * direction) : nearest;
}

} // namespace

/// As with Shoemake's arcball (1992), but around the handle's own ball: a handle on its far side is dragged
/// along the far side, so that what is held stays under the pointer. Outside the ball the nearest place of it
/// is meant, in the plane through the middle; there a drag turns about the line of sight.
Eigen::Quaterniond ballTurn(const Vector3d& centre, const Grip& grip, const Ray& ray) {
    const Vector3d arm = grip.place - centre;
    const bool isBehind =
        arm.dot(centre - grip.ray.origin) > 1e-6 * arm.norm() * (centre - grip.ray.origin).norm();
    const Ball ball{centre, arm.norm(), isBehind ? 1.0 : -1.0};
    const Vector3d from = met(ball, grip.ray), to = met(ball, ray);
    if (!(from.norm() > 0) || !(to.norm() > 0)) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(shortestTurn(from, to));
}

} // namespace esm

#include "core/dynamics/contact/collider_move.h"

#include "core/geometry/shortest_turn.h"

#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

/// With 1 the plane of a point that lay right on it could not turn at all, and tissue would not slide along
/// the collider. With 0.98 it may turn by arccos 0.98, some 11°, in a step.
constexpr double planeSlack = 0.98;
constexpr double leastLength = 1e-9; ///< of a sum of directions that has one

/// A surface point as the nearest point of a collider's axis sees it: where it lay before, where it lies now.
struct SeenPoint {
    Vector3d then, now; ///< m
};

/// The direction from the axis to where the point now lies, but turned back towards where it lay before,
/// until that place, too, is beyond the plane at `distance` from the axis. A plane that cut the old place off
/// would move the point out farther than it came in: that would give speed, and a push may only take it.
Vector3d outward(const SeenPoint& seen, double distance, const Vector3d& elseWhere) {
    const auto& [then, now] = seen;
    const double thenLength = then.norm(), nowLength = now.norm();
    if (!(thenLength > 0)) return nowLength > 0 ? Vector3d(now / nowLength) : elseWhere;
    if (!(nowLength > 0)) return then / thenLength;
    const double angle = std::acos(std::clamp(then.dot(now) / (thenLength * nowLength), -1.0, 1.0));
    const double most = std::acos(std::min(1.0, planeSlack * distance / thenLength));
    if (angle <= most) return now / nowLength;
    const Vector3d turned = std::sin(angle - most) / thenLength * then + std::sin(most) / nowLength * now;
    const double length = turned.norm();
    return length > leastLength ? Vector3d(turned / length) : Vector3d(then / thenLength);
}

Vector3d across(const Vector3d& vector, const Vector3d& axis) {
    return vector - vector.dot(axis) * axis;
}

} // namespace

ColliderMove partOf(const ColliderMove& move, double begin, double end) {
    const auto at = [&](double part) { return part < 1 ? between(move.from, move.to, part) : move.to; };
    return {move.shape, begin > 0 ? at(begin) : move.from, at(end)};
}

AxisMove::AxisMove(const ColliderMove& move)
    : from(axisOf({move.shape, move.from})), to(axisOf({move.shape, move.to})), radius(radiusOf(move.shape)),
      turns(!to.isPoint() && from.direction != to.direction) {
    if (turns) turn = shortestTurn(from.direction, to.direction);
}

// A capsule is what balls along its axis fill. A point of the surface deals with the nearest of them, as it
// would with a sphere that moves as that ball does: it is seen from the ball's centre, and turned as the axis
// was. Beside the capsule only what lies across the axis counts, for there all balls lie in one row, and a
// plane that leant along the row would push the point far beyond what is needed. Round the ends no plane may
// lean back over the row.
ContactPlane contactPlane(const AxisMove& move, const Vector3d& before, const Vector3d& after,
                          double distance) {
    const double along = move.to.nearest(after);
    ContactPlane plane{move.to.at(along), {}};
    SeenPoint seen{before - move.from.at(along), after - plane.centre};
    if (move.turns) seen.then = move.turn * seen.then;
    if (move.to.isPoint()) {
        plane.normal = outward(seen, distance, Vector3d::UnitY());
        return plane;
    }
    const Vector3d& axis = move.to.direction;
    if (std::abs(along) < move.to.half) seen = {across(seen.then, axis), across(seen.now, axis)};
    plane.normal = outward(seen, distance, axis.unitOrthogonal());
    if (along * plane.normal.dot(axis) >= 0) return plane;
    const Vector3d upright = across(plane.normal, axis);
    plane.normal = upright.norm() > leastLength ? upright.normalized() : axis.unitOrthogonal();
    return plane;
}

} // namespace esm

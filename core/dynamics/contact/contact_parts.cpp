#include "core/dynamics/contact/body_pose.h"
#include "core/dynamics/contact/contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace esm {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// Of half a radius each: 32 radii in a step.
constexpr int mostParts = 64;

/// A box, m, and for how long, s, something may come into it.
struct Way {
    AlignedBox3d box;
    double duration;
};

/// How fast the surface near the way moves at most, m/s; nothing where none comes near.
std::optional<double> surfaceSpeed(const std::vector<Triangle>& surface, const Vectors& positions,
                                   const Vectors& velocities, const Way& way) {
    std::optional<double> squared;
    for (const Triangle& triangle : surface) {
        AlignedBox3d box(positions[triangle[0]]);
        box.extend(positions[triangle[1]]).extend(positions[triangle[2]]);
        for (const std::uint32_t node : triangle)
            box.extend(positions[node] + way.duration * velocities[node]);
        if (!way.box.intersects(box)) continue;
        for (const std::uint32_t node : triangle)
            squared = std::max(squared.value_or(0), velocities[node].squaredNorm());
    }
    return squared ? std::optional(std::sqrt(*squared)) : std::nullopt;
}

/// How fast any point of a body may move, m/s; nothing where it stays away from the way.
std::optional<double> bodySpeed(const TouchedSurface::Body& body, const Vectors& positions,
                                const Vectors& velocities, const Way& way) {
    const BodyPose pose(body, positions);
    AlignedBox3d box;
    double longest = (body.second - body.first).norm();
    for (const Vector3d& point : body.points) {
        box.extend(pose.now(point));
        longest = std::max(longest, (point - body.first).norm());
    }
    const Vector3d &first = velocities[body.line.first], &second = velocities[body.line.second];
    const double line = (body.second - body.first).norm();
    const double turning = line > 0 ? (second - first).norm() * longest / line : 0;
    const double speed = std::max(first.norm(), second.norm()) + turning;
    const Vector3d reach = Vector3d::Constant(way.duration * speed);
    if (!way.box.intersects(AlignedBox3d(box.min() - reach, box.max() + reach))) return std::nullopt;
    return speed;
}

/// What a collider may come to, and half a radius more. The arcs on which ends turn lie within their length
/// of the places where they begin and end.
AlignedBox3d boxOf(const ColliderMove& move) {
    const ColliderAxis from = axisOf({move.shape, move.from}), to = axisOf({move.shape, move.to});
    AlignedBox3d box;
    for (const ColliderAxis& axis : {from, to})
        box.extend(axis.at(-axis.half)).extend(axis.at(axis.half));
    const double turning =
        mostMotion(move.shape, move.from, move.to) - (move.to.place - move.from.place).norm();
    const Vector3d margin = Vector3d::Constant(1.5 * radiusOf(move.shape) + turning);
    return {box.min() - margin, box.max() + margin};
}

} // namespace

// What touches a collider is a radius away from its axis. If both together move by no more than half a radius
// in a part, it is still half a radius away at the part's end, on the side that it came from: the way out is
// the way back, and nothing passes through. Parts are doubled and not counted up, since each length of a part
// needs a matrix of its own.
//
// A capsule's points go no farther than those of its axis, and along a straight axis it is an end that goes
// farthest: what half a radius per part is for one end, it is for all.
int contactParts(const TouchedSurface& surface, const Vectors& positions, const Vectors& velocities,
                 const std::vector<ColliderMove>& colliders, double duration) {
    int parts = 1;
    for (const ColliderMove& move : colliders) {
        const Way way{boxOf(move), duration};
        const std::optional<double> speed = surface.body
                                                ? bodySpeed(*surface.body, positions, velocities, way)
                                                : surfaceSpeed(surface.triangles, positions, velocities, way);
        if (!speed) continue;
        const double motion = mostMotion(move.shape, move.from, move.to) + duration * *speed;
        while (parts < mostParts && motion > 0.5 * radiusOf(move.shape) * parts)
            parts *= 2;
    }
    return parts;
}

} // namespace esm

#pragma once

#include "core/geometry/collider.h"

#include <vector>

namespace esm {

/// A collider on its way during a step: evenly from pose to pose.
struct ColliderMove {
    Collider shape;
    ColliderPose from, to;
};

/// Part of the way, 0 to 1 each: what remains of the move between the two.
ColliderMove partOf(const ColliderMove& move, double begin, double end);

/// The same with what contact asks of it worked out.
struct AxisMove {
    explicit AxisMove(const ColliderMove& move);

    ColliderAxis from, to;
    double radius;        ///< m
    bool turns = false;   ///< the axis, not only about itself
    Eigen::Matrix3d turn; ///< of the axis during the move, where it turns
};

/// Where the normal of a contact points, and where it begins: the axis' point that is nearest to where the
/// surface's point lies after the move.
struct ContactPlane {
    Eigen::Vector3d centre; ///< m
    Eigen::Vector3d normal;
};

/// The plane, `distance` (m) from the axis, that a surface point is to be kept beyond, which moved from
/// `before` to `after`. The collider lies on the plane's other side, so that what is beyond it is outside.
ContactPlane contactPlane(const AxisMove& move, const Eigen::Vector3d& before, const Eigen::Vector3d& after,
                          double distance);

} // namespace esm

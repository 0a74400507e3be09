#pragma once

#include <Eigen/Core>

namespace esm {

/// The rotation about the axis across both that turns a direction to another; neither need be of length 1.
/// Half a turn, which has no such axis, goes about one of those across `from`, always the same.
/// Precondition: neither is zero.
Eigen::Matrix3d shortestTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

} // namespace esm

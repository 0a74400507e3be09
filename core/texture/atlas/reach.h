#pragma once

#include <Eigen/Core>

namespace esm {

/// Left end of the points that lie nearer than `distance` to the segment p q, on the line of height y; plus
/// infinity when there is none. Pixels.
double leftReach(Eigen::Vector2d p, Eigen::Vector2d q, double y, double distance);

/// The same to the right; minus infinity when there is none.
double rightReach(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double y, double distance);

} // namespace esm

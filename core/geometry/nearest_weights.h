#pragma once

#include <Eigen/Core>

namespace esm {

/// Weights of a triangle's corners in its point that is nearest to a point: from 0 to 1, sum 1. Also for
/// triangles without area.
Eigen::Vector3d nearestWeights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c);

} // namespace esm

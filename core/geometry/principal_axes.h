#pragma once

#include <Eigen/Core>

#include <vector>

namespace esm {

/// Precondition: there are some.
Eigen::Vector3d meanOf(const std::vector<Eigen::Vector3d>& points);

/// The directions in which points spread about their mean, least first: of length 1, at right angles, each of
/// either sense. Precondition: there are some points.
Eigen::Matrix3d principalAxes(const std::vector<Eigen::Vector3d>& points);

} // namespace esm

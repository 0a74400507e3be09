#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace esm {

/// For every point the index of the point that stands for it: the first exactly equal one or, with a
/// `distance` > 0, the nearest earlier one within it that stands for itself.
std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3d>& points, double distance);

} // namespace esm

#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <vector>

namespace esm {

/// Where a trajectory, as `simulate` writes it, has the nodes at a time (s): in its last frame that is not
/// later, in its last of all without a time.
/// @throws FileError: not a trajectory, or one of `nodeCount` nodes is not in that frame or cannot be drawn
std::vector<Eigen::Vector3d> readMotionFrame(const std::filesystem::path& file, std::size_t nodeCount,
                                             std::optional<double> time);

} // namespace esm

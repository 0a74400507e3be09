#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <vector>

namespace esm {

struct MotionFrame {
    double time;                            ///< s
    std::vector<Eigen::Vector3d> positions; ///< m, one per node
};

/// Where a trajectory, as `simulate` writes it, has the nodes at a time (s): in its last frame that is not
/// later, in its last of all without a time.
/// @param nodeCounts how many nodes a frame may have, rising: at the start, and after each split of the scene
/// @throws FileError: not a trajectory, or one of that frame's nodes is missing or cannot be drawn
MotionFrame readMotionFrame(const std::filesystem::path& file, const std::vector<std::size_t>& nodeCounts,
                            std::optional<double> time);

/// How fast the nodes go at a frame, m/s: their way since the frame before it, over the time between.
/// @throws FileError as readMotionFrame() does, and where the trajectory has no frame of as many nodes before
std::vector<double> readSpeeds(const std::filesystem::path& file, const std::vector<std::size_t>& nodeCounts,
                               const MotionFrame& frame);

} // namespace esm

#pragma once

#include "core/support/progress.h"

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace esm {

/// Where the nodes are in SOFA at a time.
struct SofaState {
    double time;                            ///< s
    std::vector<Eigen::Vector3d> positions; ///< m
};

/// Reads what SOFA's WriteState has written: a line "T= time" for each state and a line "X= x y z x y z …"
/// with six digits of each place. Lines of other things are left out, as is a last line that was cut short.
/// @param most states that the file may have, by its size
/// @throws FileError where it cannot be read or is larger than those; InvalidModel for a state of another
/// number of nodes, for what is no number, and for a place that is not finite, as where the motion blew up;
/// Cancelled
std::vector<SofaState> readSofaStates(const std::filesystem::path& file, std::size_t nodes, std::size_t most,
                                      const Progress& progress = {});

} // namespace esm

#pragma once

#include "core/support/atomic_file.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// CSV `time,node,x,y,z`, a row per recorded node and frame, numbers so that they read back exactly. Frames
/// go to the disk as they come: a long run of a large organ does not fit into memory.
class TrajectoryFile {
public:
    /// @param points what the rows are of, "node" or "vertex"
    /// @param numbers theirs; none: those of their places
    /// @throws FileError
    TrajectoryFile(const std::filesystem::path& file, const std::string& points,
                   std::optional<std::vector<std::uint32_t>> numbers = {});

    void add(double time,
             const std::vector<Eigen::Vector3d>& positions); ///< m, of the points there are; time in s
    void commit() { m_file.commit(); }

private:
    AtomicFile m_file;
    std::optional<std::vector<std::uint32_t>> m_numbers;
};

} // namespace esm

#pragma once

#include "core/support/atomic_file.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace esm {

/// CSV `time,node,x,y,z`, a row per recorded node and frame, numbers so that they read back exactly. Frames
/// go to the disk as they come: a long run of a large organ does not fit into memory.
class TrajectoryFile {
public:
    TrajectoryFile(const std::filesystem::path& file,
                   std::vector<std::uint32_t> nodes); ///< @throws FileError

    void add(double time,
             const std::vector<Eigen::Vector3d>& positions); ///< one position (m) per node, time in s
    void commit() { m_file.commit(); }

private:
    AtomicFile m_file;
    std::vector<std::uint32_t> m_nodes;
};

} // namespace esm

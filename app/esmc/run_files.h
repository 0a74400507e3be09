#pragma once

#include "app/esmc/runnable_model.h"
#include "app/esmc/trajectory_file.h"

#include <optional>
#include <string>

namespace esm {

/// Where the trajectories go that a run writes.
struct RunOutputs {
    std::string nodes, surface; ///< the second is empty where it is not wanted
};

/// @throws UsageError where both trajectories would be one file
void requireTwoFiles(const RunOutputs& outputs);

/// Before the run, what would keep the surface from being written. @throws InvalidModel
void requireSurface(const RunOutputs& outputs, const RunnableModel& model);

/// The trajectories that a run writes, all or none. The model must outlive it.
class RunFiles {
public:
    RunFiles(const RunOutputs& outputs, const RunnableModel& model); ///< @throws FileError

    /// @param positions m, of the nodes that the scene records
    void add(double time, const std::vector<Eigen::Vector3d>& positions);
    void commit(Interruption& interruption); ///< @throws FileError, Cancelled

private:
    const RunnableModel& m_model;
    TrajectoryFile m_nodes;
    std::optional<TrajectoryFile> m_surface;
};

} // namespace esm

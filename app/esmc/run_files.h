#pragma once

#include "app/esmc/runnable_model.h"
#include "app/esmc/trajectory_file.h"
#include "core/dynamics/measure/scene_run.h"
#include "core/dynamics/measure/scene_stages.h"

#include <optional>
#include <string>

namespace esm {

/// Where the trajectories go that a run writes.
struct RunOutputs {
    std::string nodes, surface, forces; ///< but for the first, empty where not wanted
};

/// @throws UsageError where two of them would be one file
void requireDistinctFiles(const RunOutputs& outputs);

/// Before the run, what would keep the surface from being written. @throws InvalidModel
void requireSurface(const RunOutputs& outputs, const RunnableModel& model);

/// The same of the forces on instruments. @throws InvalidModel
void requireInstruments(const RunOutputs& outputs, const Scene& scene);

/// The files that a run writes, all or none. Model and stages must outlive it.
class RunFiles {
public:
    RunFiles(const RunOutputs& outputs, const RunnableModel& model,
             const std::vector<SceneStage>& stages); ///< @throws FileError

    /// @param positions m, of the nodes that the scene records
    void add(double time, const std::vector<Eigen::Vector3d>& positions);
    /// @param forces on the scene's instruments, written where they are wanted
    void commit(const std::vector<ForceRow>& forces,
                Interruption& interruption); ///< @throws FileError, Cancelled

private:
    std::vector<Eigen::Vector3d> drawn(const std::vector<Eigen::Vector3d>& positions) const;

    const RunnableModel& m_model;
    const std::vector<SceneStage>& m_stages;
    TrajectoryFile m_nodes;
    std::optional<TrajectoryFile> m_surface;
    std::optional<AtomicFile> m_forces;
};

} // namespace esm

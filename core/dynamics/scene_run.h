#pragma once

#include "core/dynamics/simulation.h"
#include "core/support/progress.h"

#include <functional>

namespace esm {

/// The scene's loads during the step of length `timeStep` that starts at `start`, s. `rest` are the nodes'
/// rest positions, m.
Loads loadsAt(const Scene& scene, const std::vector<Eigen::Vector3d>& rest, double start, double timeStep);

/// Receives the recorded nodes' positions at 0, every, 2·every, … and the duration, each at the first step
/// that reaches the time.
using FrameSink = std::function<void(double time, const std::vector<Eigen::Vector3d>& positions)>;

struct SceneOutcome {
    Integrator integrator = Integrator::Auto;
    double timeStep = 0; ///< s
    std::size_t steps = 0;
    double setupSeconds = 0, wallSeconds = 0, simulatedSeconds = 0;
    bool stable = true;
    std::string outcome;       ///< "completed", or why the run stopped
    Energy energy;             ///< at the end
    double activeFraction = 1; ///< share of the nodes that were computed, on the mean of all steps
    bool touched = false;      ///< the instrument touched what can move
};

/// What is run, and how.
struct SceneRun {
    const TissueModel& model;
    const TouchedSurface& surface; ///< what an instrument touches; may be empty
    const Scene& scene;
    SimulationSettings settings = {};
};

/// Runs a scene from rest. A run that diverges, or comes to a step that cannot be computed, ends with its
/// last good state and says so in the outcome.
/// @throws InvalidModel when the scene is not for the model, takes more than 10¹² steps or cannot begin;
/// Cancelled
SceneOutcome runScene(const SceneRun& run, const FrameSink& sink, const Progress& progress = {});

} // namespace esm

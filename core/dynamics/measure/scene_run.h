#pragma once

#include "core/dynamics/simulation.h"
#include "core/support/progress.h"
#include "core/support/time_source.h"

#include <functional>

namespace esm {

/// Receives the recorded nodes' positions at 0, every, 2·every, … and the duration, each at the first step
/// that reaches the time.
using FrameSink = std::function<void(double time, const std::vector<Eigen::Vector3d>& positions)>;

/// N, the forces of the tissue on the scene's instruments, on the mean since the record time before.
struct ForceRow {
    double time; ///< s
    std::vector<Eigen::Vector3d> forces;
};

/// What fluids did at a record time.
struct FluidRow {
    double time;                   ///< s
    std::vector<double> volumes;   ///< m³, by cavity of the tissue
    std::vector<double> pressures; ///< Pa, all that presses from within
};

struct SceneOutcome {
    Integrator integrator = Integrator::Auto;
    double timeStep = 0;                 ///< s, nominal, halved as often as was asked
    std::size_t steps = 0, cutSteps = 0; ///< taken; those of another length
    double shortestStep = 0;             ///< s, that was taken
    std::size_t averagedCorners = 0;     ///< where loads begin, end or turn inside a step: as Timeline says
    double setupSeconds = 0, wallSeconds = 0, simulatedSeconds = 0;
    double factorisationSeconds = 0; ///< of the set-up
    bool stable = true;
    std::string outcome;       ///< "completed", or why the run stopped
    Energy energy;             ///< at the end
    double activeFraction = 1; ///< share of the nodes that were computed, on the mean of all steps
    std::vector<InstrumentTouch> instruments; ///< one for each of the scene's
    std::vector<ForceRow> forces;             ///< at the record times; 0 at time 0. None without instruments
    std::vector<FluidRow> fluids;             ///< at the record times; none without cavities

    bool touched() const; ///< whether an instrument touched what can move
};

/// To which power of the step errors are sure to fall. Where a mean stands in for a corner of a load, they
/// depend on where in its step that lies, which each halving changes; where an instrument touches, on the
/// moment within a step at which it meets a node.
double orderOfErrors(const SceneOutcome& outcome);

/// How hard the tissue pressed on an instrument, by the rows of an outcome.
struct InstrumentForce {
    double mean = 0; ///< N, of the rows' lengths, over the time
    double peak = 0; ///< N, of the largest row
};
InstrumentForce forceOn(std::size_t instrument, const SceneOutcome& outcome);

/// What is run, and how.
struct SceneRun {
    const TissueModel& model;
    const TouchedSurface& surface; ///< what an instrument touches; may be empty
    const Scene& scene;
    SimulationSettings settings = {};
    int halvings = 0; ///< of the settings' step, and of every step that is cut, as Timeline says
    TimeSource clock = steadySeconds; ///< for the seconds of the outcome, and between two reports of progress
};

/// Runs a scene from rest. A run that diverges, or comes to a step that cannot be computed, ends with its
/// last good state; one that makes energy out of nothing ends where that was noticed, without a frame of it.
/// The outcome says so.
/// @throws InvalidModel when the scene is not for the model, takes more than 10¹² steps or cannot begin;
/// Cancelled
SceneOutcome runScene(const SceneRun& run, const FrameSink& sink, const Progress& progress = {});

} // namespace esm

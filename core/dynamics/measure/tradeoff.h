#pragma once

#include "core/dynamics/measure/measured_runs.h"
#include "core/dynamics/measure/scene_run.h"

namespace esm {

/// The scene of a run on fewer nodes.
struct CoarserRun {
    Detail detail; ///< the level that was asked for
    TissueModel model;
    TouchedSurface surface;
    Scene scene; ///< records all nodes
    /// Where its nodes carry the nodes that the full run records, m.
    std::function<std::vector<Eigen::Vector3d>(const std::vector<Eigen::Vector3d>&)> recorded;
};

struct TradeoffOptions {
    TradeoffWishes wishes = {};
    double mostSecondsPerRun = 10; ///< wall time; what would take longer, or does, is left out
    Damping damping = Damping::Isotropic;
    std::size_t threads = 0;              ///< at most; 0: as many as the tissue's size is worth
    std::vector<CoarserRun> coarser = {}; ///< measured too, against the full run
    TimeSource clock = steadySeconds;     ///< the wall's
};

/// Receives the reference, and each run as soon as it is measured.
struct TradeoffSink {
    std::function<void(const TradeoffReference&)> reference;
    std::function<void(const TradeoffRun&)> run;
};

/// Runs a scene, and its coarser runs, with every integrator, from its longest stable step to ever shorter
/// ones, in every precision, and compares each trajectory with a reference whose step is halved until its own
/// error is a tenth of the smallest that is reported: by split2, or the first of rk4, split and bdf2 that can
/// give one in the time that is allowed, ten times that of a run; or until halving gains nothing more. The
/// error of a trajectory x is √(Σ|x − x_ref|² / Σ|x_ref − x_0|²) over the recorded nodes and times that its
/// steps reach; one below ten times the reference's own is reported as at most the sum of both.
/// @throws InvalidModel when the scene is not for the model, nothing in it moves, or there is no reference;
/// Cancelled
Tradeoff measureTradeoff(const SceneRun& run, const TradeoffOptions& options, const Progress& progress = {},
                         const TradeoffSink& sink = {});

} // namespace esm

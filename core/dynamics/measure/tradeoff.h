#pragma once

#include "core/dynamics/measure/scene_run.h"
#include "core/model/detail.h"
#include "core/model/stepping.h"

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

/// What one way to step came to on a scene.
struct TradeoffRun {
    Stepping stepping;
    std::size_t nodes = 0; ///< simulated
    bool stable = false;
    double error = 0;          ///< relative to the motion itself; without meaning when not stable
    bool isErrorBound = false; ///< the error is that or less: too small to be told from the reference's own
    double wallPerSimulatedSecond = 0;  ///< on this machine
    std::optional<Detail> coarser = {}; ///< the level of detail, where it is not the scene's own

    double realTimeFactor() const { return 1 / wallPerSimulatedSecond; }
};

/// A way to step that was not measured, and why.
struct LeftOutRun {
    Stepping stepping;
    std::size_t nodes = 0; ///< simulated
    std::string reason;
};

struct TradeoffReference {
    Stepping stepping;
    double estimatedError = 0; ///< relative to the motion
    /// Its steps damp away swings of the tissue that go on in truth: no error contains anything of them.
    bool hidesSwings = false;
};

struct Tradeoff {
    TradeoffReference reference;
    std::vector<TradeoffRun> runs;
    std::vector<std::size_t> pareto;           ///< runs that none beats in error and cost, the fastest first
    std::optional<std::size_t> bestInRealTime; ///< least error
    std::optional<std::size_t> fastestToError; ///< least cost
    std::vector<LeftOutRun> leftOut;
};

struct TradeoffWishes {
    double realTimeFactor = 1; ///< at least: simulated over wall time
    double mostError = 0.01;   ///< relative to the motion
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

/// Works out anew what is best of the runs there are, as when other wishes come up.
void recommend(Tradeoff& tradeoff, const TradeoffWishes& wishes);

} // namespace esm

#pragma once

#include "core/dynamics/measure/scene_run.h"

namespace esm {

struct AccurateOutcome {
    SceneOutcome outcome;      ///< of the last run
    double estimatedError = 0; ///< of its trajectory, relative to the motion
    /// Its steps damp away swings of the tissue that go on in truth, and no run that follows them was worth
    /// waiting for: the error contains nothing of them.
    bool hidesSwings = false;
    bool isReached = true; ///< the error that was wanted
};

/// Gives what receives the frames of a run that begins; what the run before gave is void.
using NewFrameSink = std::function<FrameSink()>;

/// Runs a scene in ever shorter steps, halved from the one that is given or chosen, until the error that is
/// left, estimated from what halving changed at some of the recorded times, is at most `mostError`. Where
/// halving cannot tell, because the steps damp swings away, the error is that against a run that follows
/// them; `Auto` then becomes the integrator of that run.
/// @throws InvalidModel as runScene(), and when no step comes as near as that; Cancelled
AccurateOutcome runSceneToError(const SceneRun& run, double mostError, const NewFrameSink& newSink,
                                const Progress& progress = {});

/// What `Auto` without a step may be off, relative to the motion, where that is not too much to wait for.
inline constexpr double resolvedError = 0.05;

/// The same where integrator and step were left to `Auto`: to `resolvedError`, by an integrator of the second
/// order where viscosity does not ask for another. The step is halved once at least, and more often while
/// that takes about ten seconds at most, by a count of steps that is the same on every machine. Where that
/// does not do, the outcome is the last run, with its estimate. @throws InvalidModel as runScene(); Cancelled
AccurateOutcome runSceneResolved(const SceneRun& run, const NewFrameSink& newSink,
                                 const Progress& progress = {});

} // namespace esm

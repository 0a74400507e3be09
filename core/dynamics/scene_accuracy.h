#pragma once

#include "core/dynamics/scene_run.h"

namespace esm {

struct AccurateOutcome {
    SceneOutcome outcome;      ///< of the last run
    double estimatedError = 0; ///< of its trajectory, relative to the motion
};

/// Runs a scene in ever shorter steps, halved from the one that is given or chosen, until the error that is
/// left, estimated from what halving changed, is at most `mostError`. The sink receives the last run alone.
/// @throws InvalidModel as runScene(), when no step comes as near as that, and when no recorded time is met
/// by a step and by its half; Cancelled
AccurateOutcome runSceneToError(const SceneRun& run, double mostError, const FrameSink& sink,
                                const Progress& progress = {});

} // namespace esm

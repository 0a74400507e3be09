#include "core/dynamics/scene_accuracy.h"

#include "core/dynamics/motion_error.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <cmath>

namespace esm {

namespace {

constexpr int mostHalvings = 30;
constexpr double leastGain = 0.9; ///< what rounding spoils does not get better

struct RecordedFrame {
    double time;
    std::vector<Eigen::Vector3d> positions;
};

struct RecordedRun {
    SceneOutcome outcome;
    std::vector<RecordedFrame> frames;
};

RecordedRun recordedRun(const SceneRun& run, const Progress& progress) {
    RecordedRun recorded;
    const auto keep = [&recorded](double time, const std::vector<Eigen::Vector3d>& positions) {
        recorded.frames.push_back({time, positions});
    };
    recorded.outcome = runScene(run, keep, progress);
    return recorded;
}

/// How far the frames at the times of both are apart, relative to the motion of `finer`; 0 where nothing
/// moves.
double changeOf(const RecordedRun& coarse, const RecordedRun& finer) {
    const double sameTime = 1e-3 * finer.outcome.timeStep;
    MotionError error;
    bool moves = false;
    auto next = finer.frames.begin();
    for (const auto& [time, positions] : coarse.frames) {
        while (next != finer.frames.end() && next->time < time - sameTime)
            ++next;
        if (next == finer.frames.end()) break;
        if (next->time > time + sameTime) continue;
        error.add(positions, next->positions, finer.frames.front().positions);
        moves = moves || positions != finer.frames.front().positions;
    }
    return moves ? error.relative() : 0;
}

[[noreturn]] void refuseError(double mostError, double step) {
    throw InvalidModel("an error of " + numberText(mostError) +
                       " of the motion is not reached; at a step of " + numberText(step) +
                       " s shorter ones gain nothing: allow a larger error, or choose another integrator");
}

} // namespace

AccurateOutcome runSceneToError(const SceneRun& run, double mostError, const FrameSink& sink,
                                const Progress& progress) {
    SceneRun finer = run;
    RecordedRun last = recordedRun(run, progress);
    finer.settings.integrator = last.outcome.integrator;
    double lastChange = std::numeric_limits<double>::infinity();
    for (int halving = 1; halving <= mostHalvings; ++halving) {
        finer.settings.timeStep = last.outcome.timeStep / 2;
        RecordedRun halved = recordedRun(finer, progress);
        const bool isComparable = last.outcome.stable && halved.outcome.stable;
        const double change = isComparable ? changeOf(last, halved) : lastChange;
        last = std::move(halved);
        if (!isComparable) continue;
        const double error = remainingError(change, lastChange);
        if (error <= mostError) {
            for (const auto& [time, positions] : last.frames)
                sink(time, positions);
            return {last.outcome, error};
        }
        if (change > leastGain * lastChange) break;
        lastChange = change;
    }
    refuseError(mostError, last.outcome.timeStep);
}

} // namespace esm

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
/// moves, none where they share no time but the start.
std::optional<double> changeOf(const RecordedRun& coarse, const RecordedRun& finer) {
    const double sameTime = 1e-3 * finer.outcome.timeStep;
    MotionError error;
    bool moves = false, isShared = false;
    auto next = finer.frames.begin();
    for (const auto& [time, positions] : coarse.frames) {
        while (next != finer.frames.end() && next->time < time - sameTime)
            ++next;
        if (next == finer.frames.end()) break;
        if (next->time > time + sameTime) continue;
        error.add(positions, next->positions, finer.frames.front().positions);
        isShared = isShared || time > sameTime;
        moves = moves || positions != finer.frames.front().positions;
    }
    if (!isShared) return std::nullopt;
    return moves ? error.relative() : 0;
}

[[noreturn]] void refuseError(double mostError, double step) {
    throw InvalidModel("an error of " + numberText(mostError) +
                       " of the motion is not reached; at a step of " + numberText(step) +
                       " s shorter ones gain nothing: allow a larger error, or choose another integrator");
}

[[noreturn]] void refuseTimes(double step) {
    throw InvalidModel("steps of " + numberText(2 * step) +
                       " s and of half of that meet at no recorded time: "
                       "choose a step that divides the interval of recording, and record at least once in "
                       "the scene's duration");
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
        const bool isWhole = last.outcome.stable && halved.outcome.stable;
        const std::optional<double> change = isWhole ? changeOf(last, halved) : std::nullopt;
        last = std::move(halved);
        if (!isWhole) continue;
        if (!change) refuseTimes(last.outcome.timeStep);
        const double error = remainingError(*change, lastChange);
        if (error <= mostError) {
            for (const auto& [time, positions] : last.frames)
                sink(time, positions);
            return {last.outcome, error};
        }
        if (*change > leastGain * lastChange) break;
        lastChange = *change;
    }
    if (!last.outcome.stable)
        throw InvalidModel("at no step down to " + numberText(last.outcome.timeStep) +
                           " s does the run come to its end: " + last.outcome.outcome);
    refuseError(mostError, last.outcome.timeStep);
}

} // namespace esm

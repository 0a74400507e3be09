#include "core/dynamics/scene_accuracy.h"

#include "core/dynamics/motion_error.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <limits>

namespace esm {

namespace {

constexpr int mostHalvings = 30;
constexpr double leastGain = 0.9; ///< what rounding spoils does not get better

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

/// How far the frames at the times of both are apart, relative to the motion of the finer ones; none where
/// they share no time but the start.
std::optional<double> changeBetween(const Trajectory& coarse, const Trajectory& finer) {
    MotionError change;
    bool shared = false;
    for (const auto& [number, positions] : coarse) {
        const auto found = finer.find(number);
        if (number == 0 || found == finer.end()) continue;
        change.add(positions, found->second, finer.at(0));
        shared = true;
    }
    if (!shared) return std::nullopt;
    return change.isNone() ? 0 : change.relative();
}

/// One scene in ever shorter steps; of each run what is compared is kept.
class HalvedRuns {
public:
    HalvedRuns(const SceneRun& run, const NewFrameSink& newSink, const Progress& progress)
        : m_run(run), m_newSink(newSink), m_progress(progress) {
        take();
    }

    /// By how much it changed the motion; none where one of the two runs did not come to its end.
    std::optional<double> halve() {
        const Trajectory coarse = std::move(m_frames);
        const bool wasStable = m_outcome.stable;
        m_run.settings.integrator = m_outcome.integrator;
        m_run.settings.timeStep = m_outcome.timeStep / 2;
        take();
        if (!wasStable || !m_outcome.stable) return std::nullopt;
        const std::optional<double> change = changeBetween(coarse, m_frames);
        if (!change) refuseTimes(m_outcome.timeStep);
        return change;
    }

    const SceneOutcome& outcome() const { return m_outcome; }

private:
    void take() {
        ComparedFrames compared(m_run.scene.duration, m_run.scene.record.every);
        const FrameSink sink = m_newSink();
        const auto give = [&](double time, const Vectors& positions) {
            compared.add(time, positions);
            sink(time, positions);
        };
        m_outcome = runScene(m_run, give, m_progress);
        m_frames = compared.frames();
    }

    SceneRun m_run;
    const NewFrameSink& m_newSink;
    const Progress& m_progress;
    SceneOutcome m_outcome; ///< of the last run
    Trajectory m_frames;
};

} // namespace

AccurateOutcome runSceneToError(const SceneRun& run, double mostError, const NewFrameSink& newSink,
                                const Progress& progress) {
    HalvedRuns runs(run, newSink, progress);
    double lastChange = std::numeric_limits<double>::infinity();
    for (int halving = 1; halving <= mostHalvings; ++halving) {
        const std::optional<double> change = runs.halve();
        if (!change) continue;
        const double error = remainingError(*change, lastChange);
        if (error <= mostError) return {runs.outcome(), error};
        if (*change > leastGain * lastChange) break;
        lastChange = *change;
    }
    if (!runs.outcome().stable)
        throw InvalidModel("at no step down to " + numberText(runs.outcome().timeStep) +
                           " s does the run come to its end: " + runs.outcome().outcome);
    refuseError(mostError, runs.outcome().timeStep);
}

} // namespace esm

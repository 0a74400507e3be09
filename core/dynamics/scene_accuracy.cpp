#include "core/dynamics/scene_accuracy.h"

#include "core/dynamics/motion_error.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <cmath>
#include <deque>

namespace esm {

namespace {

constexpr int mostHalvings = 30;
constexpr double leastGain = 0.9; ///< what rounding spoils does not get better

struct RecordedFrame {
    double time;
    std::vector<Eigen::Vector3d> positions;
};

using RecordedFrames = std::deque<RecordedFrame>;

struct RecordedRun {
    SceneOutcome outcome;
    RecordedFrames frames;
};

/// Holds the frames of a run in finer steps, as they come, against those of a coarse one, which it drops on
/// the way: only one run's are held at a time.
class FrameComparison {
public:
    /// @param sameTime s, less than which times are apart only by rounding
    FrameComparison(RecordedFrames coarse, double sameTime)
        : m_coarse(std::move(coarse)), m_sameTime(sameTime) {}

    void add(const RecordedFrame& finer) {
        if (m_start.empty()) m_start = finer.positions;
        while (!m_coarse.empty() && m_coarse.front().time < finer.time - m_sameTime)
            m_coarse.pop_front();
        if (m_coarse.empty() || m_coarse.front().time > finer.time + m_sameTime) return;
        const auto& [time, positions] = m_coarse.front();
        m_error.add(positions, finer.positions, m_start);
        m_isShared = m_isShared || time > m_sameTime;
        m_moves = m_moves || positions != m_start;
        m_coarse.pop_front();
    }

    /// How far the frames at the times of both are apart, relative to the motion of the finer ones; 0 where
    /// nothing moves, none where they share no time but the start.
    std::optional<double> change() const {
        if (!m_isShared) return std::nullopt;
        return m_moves ? m_error.relative() : 0;
    }

private:
    RecordedFrames m_coarse;
    double m_sameTime; ///< s
    std::vector<Eigen::Vector3d> m_start;
    MotionError m_error;
    bool m_moves = false, m_isShared = false;
};

RecordedRun recordedRun(const SceneRun& run, const Progress& progress, FrameComparison* comparison) {
    RecordedRun recorded;
    const auto keep = [&](double time, const std::vector<Eigen::Vector3d>& positions) {
        recorded.frames.push_back({time, positions});
        if (comparison) comparison->add(recorded.frames.back());
    };
    recorded.outcome = runScene(run, keep, progress);
    return recorded;
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
    RecordedRun last = recordedRun(run, progress, nullptr);
    finer.settings.integrator = last.outcome.integrator;
    double lastChange = std::numeric_limits<double>::infinity();
    for (int halving = 1; halving <= mostHalvings; ++halving) {
        finer.settings.timeStep = last.outcome.timeStep / 2;
        FrameComparison comparison(std::move(last.frames), 1e-3 * *finer.settings.timeStep);
        RecordedRun halved = recordedRun(finer, progress, &comparison);
        const bool isWhole = last.outcome.stable && halved.outcome.stable;
        const std::optional<double> change = isWhole ? comparison.change() : std::nullopt;
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

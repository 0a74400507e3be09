#include "core/dynamics/tradeoff.h"

#include "core/dynamics/motion_error.h"
#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double stabilityMargin = 0.95;
constexpr double longestShare = 0.25; ///< a step is at most this part of the scene
constexpr double mostFrames = 50;     ///< compared
constexpr int mostShorterSteps = 8;
constexpr int mostReferenceRuns = 17;
constexpr double referenceShare = 0.3;   ///< of the whole work
constexpr double referencePatience = 10; ///< times what another run may take
constexpr double referenceMargin = 10;   ///< between the smallest error reported and the reference's own
constexpr double finestError = 1e-5;     ///< relative; what is asked of the smallest errors

struct Measured {
    SceneOutcome outcome;
    Trajectory trajectory;
};

/// The tissue at one level of detail.
struct Level {
    SceneRun run;
    const CoarserRun* coarser; ///< null: the full one
    CriticalSteps limits;
};

class Measurement {
public:
    Measurement(const SceneRun& run, const TradeoffOptions& options, const Progress& progress,
                const TradeoffSink& sink)
        : m_run(run), m_options(options), m_progress(progress), m_sink(sink) {
        addLevel(run, nullptr);
        for (const CoarserRun& coarser : options.coarser)
            addLevel({coarser.model, coarser.surface, coarser.scene}, &coarser);
        m_level = &m_levels.front();
        const double every = std::min(run.scene.record.every, run.scene.duration);
        m_interval = every * std::ceil(run.scene.duration / every / mostFrames);
    }

    Tradeoff measure() {
        findReference();
        for (std::size_t level = 0; level < m_levels.size(); ++level) {
            m_level = &m_levels[level];
            const auto ways = waysToStep();
            for (std::size_t i = 0; i < ways.size(); ++i) {
                const double done =
                    static_cast<double>(level) + static_cast<double>(i) / static_cast<double>(ways.size());
                m_fraction =
                    referenceShare + (1 - referenceShare) * done / static_cast<double>(m_levels.size());
                refine(ways[i]);
            }
        }
        recommend(m_result, m_options.wishes);
        return std::move(m_result);
    }

private:
    bool isWanted() const { return !m_progress || m_progress(m_fraction); }

    void addLevel(const SceneRun& run, const CoarserRun* coarser) {
        m_levels.push_back({run, coarser,
                            criticalSteps(run.model, m_options.damping,
                                          {1e-3, Deformation::Any, [this](double) { return isWanted(); }})});
    }

    /// The longest step that is stable and, itself or halved, meets the times that are compared.
    double longestStep(Integrator integrator) const {
        const auto limit = m_level->limits.find(integrator);
        if (limit == m_level->limits.end() || !limit->second) return 0;
        const double longest =
            std::min(stabilityMargin * *limit->second, longestShare * m_run.scene.duration);
        const double intervals = longest / m_interval;
        return m_interval *
               (intervals >= 1 ? std::exp2(std::floor(std::log2(intervals))) : 1 / std::ceil(1 / intervals));
    }

    std::vector<Stepping> waysToStep() const {
        std::vector<Stepping> ways;
        for (const Integrator integrator : allIntegrators) {
            const double step = longestStep(integrator);
            if (!(step >= shortestStep)) continue;
            ways.push_back({integrator, step, Precision::Double});
            if (isExplicit(integrator)) ways.push_back({integrator, step, Precision::Float});
        }
        return ways;
    }

    Measured run(const Stepping& stepping, double duration) const {
        Scene scene = m_level->run.scene;
        scene.duration = duration;
        scene.record.every = std::max(m_interval, stepping.timeStep);
        SimulationSettings settings = withStepping({}, stepping);
        settings.damping = m_options.damping;
        settings.threads = m_options.threads;
        Measured measured;
        const auto keep = [&](double time, const Vectors& positions) {
            const double number = std::round(time / m_interval);
            if (std::abs(time - number * m_interval) < 1e-6 * m_interval)
                measured.trajectory[static_cast<long>(number)] =
                    m_level->coarser ? m_level->coarser->recorded(positions) : positions;
        };
        measured.outcome = runScene({m_level->run.model, m_level->run.surface, scene, settings}, keep,
                                    [this](double) { return isWanted(); });
        return measured;
    }

    /// From some steps at the scene's start, s of wall time for the whole of it.
    double predictedSeconds(const Stepping& stepping) const {
        constexpr double steps = 4;
        const SceneOutcome outcome = run(stepping, steps * stepping.timeStep).outcome;
        return outcome.wallSeconds / steps * m_run.scene.duration / stepping.timeStep;
    }

    void findReference() {
        const bool isSplit = longestStep(Integrator::Split2) >= shortestStep;
        Stepping stepping{isSplit ? Integrator::Split2 : Integrator::Rk4, 0, Precision::Double};
        stepping.timeStep = std::min(m_interval, longestStep(stepping.integrator));
        const double wanted = std::min(finestError, m_options.wishes.mostError / 100) / referenceMargin;
        double lastChange = std::numeric_limits<double>::infinity(), error = lastChange;
        for (int runs = 0; runs < mostReferenceRuns && error > wanted; ++runs, stepping.timeStep /= 2) {
            m_fraction = referenceShare * runs / mostReferenceRuns;
            if (predictedSeconds(stepping) > referencePatience * m_options.mostSecondsPerRun) break;
            Measured finer = run(stepping, m_run.scene.duration);
            if (!finer.outcome.stable) break;
            if (runs > 0) {
                const double change = changeTo(finer.trajectory);
                error = remainingError(change, lastChange);
                lastChange = change;
                m_result.reference = {stepping, error};
            }
            m_reference = std::move(finer.trajectory);
        }
        if (std::isinf(error))
            throw InvalidModel("no reference can be computed in the time that is allowed: allow more of it, "
                               "or shorten the scene");
        if (m_sink.reference) m_sink.reference(m_result.reference);
    }

    /// From the reference there was, relative to the motion.
    double changeTo(const Trajectory& finer) const {
        const double change = relativeError(m_reference, finer);
        if (std::isinf(change))
            throw InvalidModel(
                "nothing in the scene moves the tissue: give it a force, a move or an instrument");
        return change;
    }

    std::size_t nodes() const { return m_level->run.model.mass.size(); }

    void leaveOut(const Stepping& stepping, const std::string& reason) {
        m_result.leftOut.push_back(std::string(integratorName(stepping.integrator)) +
                                   (stepping.precision == Precision::Float ? " in float" : "") + " at " +
                                   numberText(stepping.timeStep) + " s" +
                                   (m_level->coarser ? " on " + std::to_string(nodes()) + " nodes: " : ": ") +
                                   reason);
    }

    /// Halves the step until the error cannot be told from the reference's, or time runs out.
    void refine(Stepping stepping) {
        double lastError = std::numeric_limits<double>::infinity();
        for (int halving = 0; halving < mostShorterSteps; ++halving, stepping.timeStep /= 2) {
            try {
                const double seconds = predictedSeconds(stepping);
                if (seconds > m_options.mostSecondsPerRun)
                    return leaveOut(stepping, "would take " + numberText(seconds) + " s");
                const TradeoffRun result = resultOf(stepping);
                const bool isTold = result.error >= referenceMargin * m_result.reference.estimatedError;
                if (result.stable && !isTold) return;
                m_result.runs.push_back(result);
                if (m_sink.run) m_sink.run(result);
                if (!result.stable) continue;
                // What rounding spoils does not get better.
                if (result.error > 0.9 * lastError) return;
                lastError = result.error;
            } catch (const InvalidModel& reason) {
                leaveOut(stepping, joined(reason.problems(), "; "));
            }
        }
    }

    TradeoffRun resultOf(const Stepping& stepping) const {
        const auto [outcome, trajectory] = run(stepping, m_run.scene.duration);
        return {stepping,
                nodes(),
                outcome.stable,
                relativeError(trajectory, m_reference),
                outcome.wallSeconds / outcome.simulatedSeconds,
                m_level->coarser ? std::optional(m_level->coarser->detail) : std::nullopt};
    }

    const SceneRun& m_run;
    const TradeoffOptions& m_options;
    const Progress& m_progress;
    const TradeoffSink& m_sink;
    double m_fraction = 0;          ///< done
    std::vector<Level> m_levels;    ///< the full one first
    const Level* m_level = nullptr; ///< the one at work
    double m_interval;              ///< s, between the times that are compared
    Trajectory m_reference;
    Tradeoff m_result;
};

/// Those that none beats in error and cost, the fastest first.
std::vector<std::size_t> paretoFront(const std::vector<TradeoffRun>& runs) {
    std::vector<std::size_t> stable;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].stable) stable.push_back(i);
    std::sort(stable.begin(), stable.end(), [&](std::size_t a, std::size_t b) {
        return runs[a].wallPerSimulatedSecond < runs[b].wallPerSimulatedSecond;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : stable)
        if (front.empty() || runs[i].error < runs[front.back()].error) front.push_back(i);
    return front;
}

} // namespace

Tradeoff measureTradeoff(const SceneRun& run, const TradeoffOptions& options, const Progress& progress,
                         const TradeoffSink& sink) {
    if (auto problems = validate(run.scene, run.model.mass.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    return Measurement(run, options, progress, sink).measure();
}

void recommend(Tradeoff& tradeoff, const TradeoffWishes& wishes) {
    tradeoff.pareto = paretoFront(tradeoff.runs);
    tradeoff.bestInRealTime = tradeoff.fastestToError = std::nullopt;
    for (const std::size_t i : tradeoff.pareto) {
        const TradeoffRun& run = tradeoff.runs[i];
        if (run.realTimeFactor() >= wishes.realTimeFactor) tradeoff.bestInRealTime = i;
        if (!tradeoff.fastestToError && run.error <= wishes.mostError) tradeoff.fastestToError = i;
    }
}

} // namespace esm

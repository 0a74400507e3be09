#include "core/dynamics/measure/tradeoff.h"

#include "core/dynamics/measure/motion_error.h"
#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/stability/swings.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

constexpr double stabilityMargin = 0.95;
constexpr double longestShare = 0.25; ///< a step is at most this part of the scene
constexpr double mostFrames = 50;     ///< compared
constexpr int mostShorterSteps = 8;
constexpr int mostToWish = 14; ///< of them, while the error that is wanted is not reached
constexpr int mostReferenceRuns = 17;
constexpr double referenceShare = 0.3;   ///< of the whole work
constexpr double referencePatience = 10; ///< times what another run may take
constexpr double referenceMargin = 10;   ///< between the smallest error reported and the reference's own
constexpr double finestError = 1e-5;     ///< relative; what is asked of the smallest errors
constexpr double worthStopping = 0.1;    ///< s

/// In the order in which they are tried. Only the last may damp swings away in long steps.
constexpr std::array referenceIntegrators{Integrator::Split2, Integrator::Rk4, Integrator::Split,
                                          Integrator::Bdf2};

/// So many halvings without gain are tried before an integrator is given up. In float none: rounding soon
/// spoils what shorter steps gain. With fewer nodes two: such a run stays off the full one, however short its
/// steps. All others come to the reference in the end, though an instrument may hide for a while what they
/// gain.
int halvingsInVain(Precision precision, bool isFull) {
    if (precision == Precision::Float) return 0;
    return isFull ? mostShorterSteps : 2;
}

struct Measured {
    SceneOutcome outcome;
    Trajectory trajectory;
    std::string problem;     ///< why there is no outcome; empty when there is
    bool isOverTime = false; ///< that is the problem
};

/// A limit on the time of a clock, from when it is started on.
class TimeLimit {
public:
    TimeLimit(double seconds, const TimeSource& clock)
        : m_seconds(std::max(seconds, worthStopping)), m_clock(clock) {}

    void start() {
        if (!m_start) m_start = m_clock();
    }
    bool isReached() const { return m_start && m_clock() - *m_start > m_seconds; }

private:
    double m_seconds;
    const TimeSource& m_clock;
    std::optional<double> m_start;
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
                const double share = (1 - referenceShare) / static_cast<double>(m_levels.size());
                const double part = share / static_cast<double>(ways.size());
                refine(ways[i],
                       {referenceShare + static_cast<double>(level) * share + static_cast<double>(i) * part,
                        part});
            }
        }
        recommend(m_result, m_options.wishes);
        return std::move(m_result);
    }

private:
    /// Of all the work, where a part of it begins and how much it is.
    struct Part {
        double from = 0, share = 0;
    };

    /// @param done fraction of the part at work; what was reported is not taken back
    bool isWanted(double done) {
        m_done = std::max(m_done, m_part.from + m_part.share * done);
        return !m_progress || m_progress(m_done);
    }

    void addLevel(const SceneRun& run, const CoarserRun* coarser) {
        m_levels.push_back({run, coarser,
                            criticalSteps(run.model, m_options.damping,
                                          {1e-3, Deformation::Any, [this](double) { return isWanted(0); }})});
    }

    /// The longest step that is stable and, itself or halved, meets the times that are compared. Trajectories
    /// are compared at the same times only: to interpolate between steps would add an error that may be
    /// larger than the integrator's own.
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
            if (!(step >= shortestStep) || traitsOf(integrator).lagsWhereTissueTurns) continue;
            ways.push_back({integrator, step, Precision::Double});
            if (isExplicit(integrator)) ways.push_back({integrator, step, Precision::Float});
        }
        return ways;
    }

    /// @param halvings of the step and of all that it is cut to
    Measured run(const Stepping& stepping, int halvings, double duration, double mostSeconds) {
        Scene scene = m_level->run.scene;
        scene.duration = duration;
        scene.record.every = std::max(m_interval, stepping.timeStep);
        SimulationSettings settings = withStepping({}, stepping);
        settings.timeStep = std::ldexp(stepping.timeStep, halvings);
        settings.damping = m_options.damping;
        settings.threads = m_options.threads;
        Measured measured;
        TimeLimit limit(mostSeconds, m_options.clock);
        const auto keep = [&](double time, const Vectors& positions) {
            limit.start();
            const double number = std::round(time / m_interval);
            if (std::abs(time - number * m_interval) < 1e-6 * m_interval)
                measured.trajectory[static_cast<long>(number)] =
                    m_level->coarser ? m_level->coarser->recorded(positions) : positions;
        };
        const double part = duration / m_run.scene.duration;
        const auto goesOn = [&](double done) {
            measured.isOverTime = done < 1 && limit.isReached();
            return !measured.isOverTime && isWanted(done * part);
        };
        try {
            measured.outcome = runScene(
                {m_level->run.model, m_level->run.surface, scene, settings, halvings, m_options.clock}, keep,
                goesOn);
        } catch (const Cancelled&) {
            if (!measured.isOverTime) throw;
            measured.problem = "took longer than the " + roundedText(mostSeconds) + " s that it may";
        }
        return measured;
    }

    /// A run of all of the scene, where it does not take longer than it may, as is forecast from some steps
    /// at the start. The forecast spares what is certainly too slow. It may be wrong, as where contact comes
    /// later, so that the run itself is stopped too when its time is up.
    Measured wholeRun(const Stepping& stepping, double mostSeconds, int halvings = 0) {
        constexpr double steps = 4;
        try {
            Measured start = run(stepping, 0, steps * stepping.timeStep, mostSeconds);
            if (!start.problem.empty()) return start;
            const double seconds =
                start.outcome.wallSeconds / steps * m_run.scene.duration / stepping.timeStep;
            if (seconds > mostSeconds)
                return {{},
                        {},
                        "would take " + roundedText(seconds, 2) + " s, more than the " +
                            roundedText(mostSeconds) + " s that it may",
                        true};
            return run(stepping, halvings, m_run.scene.duration, mostSeconds);
        } catch (const InvalidModel& reason) {
            return {{}, {}, joined(reason.problems(), "; "), false};
        }
    }

    /// Of which a run is asked; smaller ones are welcome.
    double smallestError() const { return std::min(finestError, m_options.wishes.mostError / 100); }

    bool hasReference() const { return !std::isinf(m_result.reference.estimatedError); }

    void findReference() {
        m_result.reference.estimatedError = std::numeric_limits<double>::infinity();
        const SwingBounds swings = swingBounds(m_run.model, m_options.damping);
        std::vector<std::string> problems;
        constexpr double share = referenceShare / referenceIntegrators.size();
        for (std::size_t i = 0; i < referenceIntegrators.size(); ++i) {
            const std::string problem =
                refineReference(referenceIntegrators[i], swings, {static_cast<double>(i) * share, share});
            if (hasReference()) break;
            problems.push_back(std::string(integratorName(referenceIntegrators[i])) + ": " + problem);
        }
        if (!hasReference())
            throw InvalidModel("no reference can be computed: " + joined(problems, "; ") +
                               "; allow more time, or shorten the scene");
        if (m_sink.reference) m_sink.reference(m_result.reference);
    }

    /// Halves the step of an integrator until its error is small enough for a reference, or time runs out.
    /// Why it went no further.
    std::string refineReference(Integrator integrator, const SwingBounds& swings, const Part& part) {
        Stepping stepping{integrator, std::min(m_interval, longestStep(integrator)), Precision::Double};
        if (!(stepping.timeStep >= shortestStep)) return "no step is stable";
        const double wanted = smallestError() / referenceMargin;
        const double patience = referencePatience * m_options.mostSecondsPerRun;
        HalvingChanges changes;
        std::string problem;
        m_reference.clear();
        for (int runs = 0; runs < mostReferenceRuns; ++runs, stepping.timeStep /= 2) {
            m_part = {part.from + part.share * runs / mostReferenceRuns, part.share / mostReferenceRuns};
            Measured finer = wholeRun(stepping, patience, runs);
            if (finer.problem.empty() && !finer.outcome.stable) finer.problem = finer.outcome.outcome;
            if (!finer.problem.empty()) {
                if (finer.isOverTime || hasReference()) return finer.problem;
                problem = finer.problem;
                m_reference.clear();
                continue;
            }
            if (!m_reference.empty()) {
                changes.add(changeTo(finer.trajectory), orderOfErrors(finer.outcome));
                const bool hides =
                    hidesSwings(swings, integrator, 2 * stepping.timeStep, m_run.scene.duration);
                m_result.reference = {stepping, changes.remaining(), hides};
            }
            m_reference = std::move(finer.trajectory);
            // Explicit steps soon follow the swings themselves.
            const bool goesOn = m_result.reference.hidesSwings && isExplicit(integrator);
            const bool isEnough = m_result.reference.estimatedError <= wanted ||
                                  (changes.standsStill() && !m_result.reference.hidesSwings);
            if (isEnough && !goesOn) return {};
        }
        return problem;
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

    /// Halves the step until the error cannot be told from the reference's, or time runs out.
    void refine(Stepping stepping, Part part) {
        double leastError = std::numeric_limits<double>::infinity();
        const double enough = std::max(smallestError(), 2 * m_result.reference.estimatedError);
        int inVain = 0;
        const auto isWorthTrying = [&](int halving) {
            return halving < (leastError > m_options.wishes.mostError ? mostToWish : mostShorterSteps);
        };
        for (int halving = 0; isWorthTrying(halving); ++halving, stepping.timeStep /= 2) {
            // How many there will be is not known: each takes half of what is left.
            m_part = {part.from, part.share / 2};
            part = {part.from + part.share / 2, part.share / 2};
            const Measured measured = wholeRun(stepping, m_options.mostSecondsPerRun);
            if (!measured.problem.empty()) m_result.leftOut.push_back({stepping, nodes(), measured.problem});
            if (measured.isOverTime) return;
            if (!measured.problem.empty()) continue;
            const TradeoffRun result = resultOf(stepping, measured);
            m_result.runs.push_back(result);
            if (m_sink.run) m_sink.run(result);
            if (!result.stable) continue;
            if (result.isErrorBound && result.error <= enough) return;
            const bool gains = result.error <= leastGain * leastError;
            if (!gains && inVain++ == halvingsInVain(stepping.precision, !m_level->coarser)) return;
            leastError = std::min(leastError, result.error);
        }
    }

    TradeoffRun resultOf(const Stepping& stepping, const Measured& measured) const {
        const SceneOutcome& outcome = measured.outcome;
        const double error = relativeError(measured.trajectory, m_reference);
        const double own = m_result.reference.estimatedError;
        const bool isBound = error < referenceMargin * own;
        return {stepping,
                nodes(),
                outcome.stable,
                isBound ? error + own : error,
                isBound,
                outcome.wallSeconds / outcome.simulatedSeconds,
                m_level->coarser ? std::optional(m_level->coarser->detail) : std::nullopt};
    }

    const SceneRun& m_run;
    const TradeoffOptions& m_options;
    const Progress& m_progress;
    const TradeoffSink& m_sink;
    Part m_part;                    ///< at work
    double m_done = 0;              ///< of all the work, as was reported
    std::vector<Level> m_levels;    ///< the full one first
    const Level* m_level = nullptr; ///< the one at work
    double m_interval;              ///< s, between the times that are compared
    Trajectory m_reference;
    Tradeoff m_result;
};

/// Those that none beats in error and cost, the fastest first. In the order of their cost a run belongs to
/// them if its error is less than that of all before it, of which the last that belongs has the least.
std::vector<std::size_t> paretoFront(const std::vector<TradeoffRun>& runs) {
    std::vector<std::size_t> ofUse;
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].isOfUse()) ofUse.push_back(i);
    std::sort(ofUse.begin(), ofUse.end(), [&](std::size_t a, std::size_t b) {
        return runs[a].wallPerSimulatedSecond < runs[b].wallPerSimulatedSecond;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : ofUse)
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

std::vector<bool> unbeatenRuns(const Tradeoff& tradeoff) {
    std::vector<bool> unbeaten(tradeoff.runs.size(), false);
    for (const std::size_t i : tradeoff.pareto)
        unbeaten[i] = true;
    return unbeaten;
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

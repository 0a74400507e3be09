#include "core/dynamics/measure/scene_accuracy.h"

#include "core/dynamics/measure/motion_error.h"
#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/stability/swings.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

/// From the shortest step there is, 1 ns, 30 doublings lead to a second: no longer one is worth halving.
constexpr int mostHalvings = 30;
/// Of the error that is wanted, for a run that others are held against: it is added to theirs, and must leave
/// room.
constexpr double followedShare = 0.25;

[[noreturn]] void refuseError(double mostError, double step, Precision precision) {
    const std::string choices =
        precision == Precision::Float
            ? "single precision rounds each step: choose double, or allow a larger error"
            : "allow a larger error, or choose another integrator";
    throw InvalidModel("an error of " + roundedText(mostError) +
                       " of the motion is not reached; at a step of " + roundedText(step) +
                       " s shorter ones gain nothing: " + choices);
}

[[noreturn]] void refuseSwings(const SceneOutcome& outcome, double error, Integrator follower) {
    const std::string follows = integratorName(follower);
    throw InvalidModel(std::string(integratorName(outcome.integrator)) +
                       " damps away swings that are faster than its steps: at " +
                       roundedText(outcome.timeStep) + " s it is " + percentText(error) +
                       " of the motion off a run by " + follows +
                       ", which follows them, and shorter ones gain little or would take long: choose " +
                       follows + ", or allow a larger error");
}

/// One scene in ever shorter steps; of each run what is compared is kept.
class HalvedRuns {
public:
    HalvedRuns(const SceneRun& run, const NewFrameSink& newSink, const Progress& progress)
        : m_run(run), m_newSink(newSink), m_progress(progress) {
        take();
        m_run.settings.integrator = m_outcome.integrator;
        m_run.settings.timeStep = m_outcome.timeStep;
    }

    /// By how much it changed the motion; none where one of the two runs did not come to its end.
    std::optional<double> halve() {
        const Trajectory coarse = std::move(m_frames);
        const bool wasStable = m_outcome.stable;
        ++m_run.halvings;
        take();
        if (!wasStable || !m_outcome.stable) return std::nullopt;
        return changeBetween(coarse, m_frames);
    }

    const SceneOutcome& outcome() const { return m_outcome; }
    const Trajectory& frames() const { return m_frames; }

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

/// In float a step that gains nothing is spoilt by rounding, which may be as large as the motion: shorter
/// ones gain nothing either.
HalvingPatience patienceOf(const SimulationSettings& settings) {
    return settings.precision == Precision::Float ? HalvingPatience{1, 1} : HalvingPatience{};
}

/// A run that follows the swings, and how far it may be off itself, relative to the motion.
struct FollowedRun {
    Integrator integrator;
    Trajectory frames;
    double error;

    double errorOf(const HalvedRuns& runs) const { return changeBetween(runs.frames(), frames) + error; }
};

// Halving tells the error of what steps follow. Steps that damp a swing away do so at half their length as
// well: two runs then agree on a motion that is wrong. Integrators that do that where the tissue would go on
// swinging are therefore held against a run by one that follows the swings, whose own error is at most a
// quarter of what is wanted and is added.
class AccuracySearch {
public:
    AccuracySearch(const SceneRun& run, double mostError, const Progress& progress)
        : m_run(run), m_mostError(mostError), m_progress(progress),
          m_swings(swingBounds(run.model, run.settings.damping)) {}

    /// @param mostSteps more than these are not worth waiting for
    AccurateOutcome search(const NewFrameSink& newSink,
                           double mostSteps = std::numeric_limits<double>::infinity()) const {
        HalvedRuns runs(m_run, newSink, m_progress);
        AccurateOutcome found = closest(runs, mostSteps, 0);
        if (found.isReached) return found;
        if (found.hidesSwings && !isExplicit(found.outcome.integrator))
            return withSwings(runs, found.estimatedError, newSink);
        if (!found.outcome.stable)
            throw InvalidModel("at no step down to " + roundedText(found.outcome.timeStep) +
                               " s does the run come to its end: " + found.outcome.outcome);
        refuseError(m_mostError, found.outcome.timeStep, m_run.settings.precision);
    }

    /// As far as is worth waiting for. @param leastHalvings however many steps they take
    AccurateOutcome closest(HalvedRuns& runs, double mostSteps, int leastHalvings) const {
        HalvingChanges halvings(patienceOf(m_run.settings));
        AccurateOutcome found{runs.outcome(), std::numeric_limits<double>::infinity(), false, false};
        for (int halving = 1; halving <= mostHalvings; ++halving) {
            const bool isWorthIt =
                2 * stepsOfWhole(runs.outcome()) <= mostSteps && runs.outcome().timeStep / 2 >= shortestStep;
            if (halving > leastHalvings && !isWorthIt) break;
            const std::optional<double> change = runs.halve();
            found.outcome = runs.outcome();
            if (!change) continue;
            halvings.add(*change, orderOfErrors(runs.outcome()));
            const double error = halvings.remaining();
            const bool hides = hidesSwings(m_swings, runs.outcome().integrator, 2 * runs.outcome().timeStep,
                                           m_run.scene.duration);
            found = {runs.outcome(), error, hides, error <= m_mostError && !hides};
            if (found.isReached) return found;
            // An explicit one soon follows them itself.
            const bool stays = hides && !isExplicit(runs.outcome().integrator);
            if (stays && (error <= m_mostError || !halvings.gained())) break;
            if (halvings.standsStill()) break;
        }
        return found;
    }

private:
    /// Also of one that did not come to its end.
    double stepsOfWhole(const SceneOutcome& outcome) const {
        return std::max(static_cast<double>(outcome.steps), m_run.scene.duration / outcome.timeStep);
    }

    /// Goes on against a run that follows the swings.
    AccurateOutcome withSwings(HalvedRuns& runs, double error, const NewFrameSink& newSink) const {
        const auto steps = followingSteps(m_run.model, m_run.settings.damping, m_run.scene.duration);
        if (steps && m_run.settings.integrator == Integrator::Auto)
            return AccuracySearch(following(*steps), m_mostError, m_progress).search(newSink);
        const std::optional<FollowedRun> followed = steps ? follow(*steps) : std::nullopt;
        if (!followed && error > m_mostError)
            refuseError(m_mostError, runs.outcome().timeStep, m_run.settings.precision);
        if (!followed) return {runs.outcome(), error, true};
        for (double last = std::numeric_limits<double>::infinity();; last = error) {
            error = followed->errorOf(runs);
            if (error <= m_mostError) return {runs.outcome(), error};
            if (error > leastGain * last && !mayGainLater(runs.outcome()))
                refuseSwings(runs.outcome(), error, followed->integrator);
            runs.halve();
        }
    }

    /// Steps that still damp swings away gain nothing until they follow them.
    bool mayGainLater(const SceneOutcome& outcome) const {
        constexpr double patience = 10; // s
        const double most = patience * stepsPerSecond(makeSpringSystem(m_run.model), outcome.integrator);
        return hidesSwings(m_swings, outcome.integrator, outcome.timeStep, m_run.scene.duration) &&
               2 * stepsOfWhole(outcome) <= most;
    }

    SceneRun following(const FollowingSteps& steps) const {
        SceneRun run = m_run;
        run.settings.integrator = steps.integrator;
        run.settings.timeStep.reset();
        return run;
    }

    std::optional<FollowedRun> follow(const FollowingSteps& steps) const {
        ComparedFrames frames(m_run.scene.duration, m_run.scene.record.every);
        const NewFrameSink newSink = [&]() -> FrameSink {
            frames = ComparedFrames(m_run.scene.duration, m_run.scene.record.every);
            return [&frames](double time, const Vectors& positions) { frames.add(time, positions); };
        };
        try {
            const AccuracySearch exact(following(steps), followedShare * m_mostError, m_progress);
            const AccurateOutcome outcome = exact.search(newSink, steps.most);
            return FollowedRun{steps.integrator, frames.frames(), outcome.estimatedError};
        } catch (const InvalidModel&) {
            return std::nullopt; // not to be had in the steps that are worth waiting for
        }
    }

    SceneRun m_run;
    double m_mostError;
    const Progress& m_progress;
    SwingBounds m_swings;
};

/// What `Auto` steps by where results count: where viscosity is so small that elasticity alone limits the
/// step, Verlet's second order costs next to nothing more than Euler's first.
SimulationSettings resolvedSettings(const SceneRun& run) {
    constexpr double worthItsOrder = 0.5; // of Euler's step
    SimulationSettings settings = run.settings;
    if (settings.precision == Precision::Float || settings.restTolerance > 0) return settings;
    const ChosenStep chosen = chooseStep(run.model, settings);
    settings.integrator = chosen.integrator;
    // Under an instrument both are of the first order, and Euler's error is the smaller one.
    if (chosen.integrator != Integrator::Euler || !run.scene.instruments.empty()) return settings;
    settings.integrator = Integrator::Verlet;
    if (chooseStep(run.model, settings).timeStep < worthItsOrder * chosen.timeStep)
        settings.integrator = Integrator::Euler;
    return settings;
}

} // namespace

// As runSceneToError() with an error of 5 %, but for somebody who asked for none. Where it is not reached in
// the steps that are worth waiting for, the last run stands with its estimate. Steps are counted and not
// timed: the same scene has the same result on every machine.
AccurateOutcome runSceneResolved(const SceneRun& run, const NewFrameSink& newSink, const Progress& progress) {
    constexpr double patience = 10; // s
    SceneRun resolved = run;
    resolved.settings = resolvedSettings(run);
    const auto closest = [&](double mostSteps) {
        HalvedRuns runs(resolved, newSink, progress);
        return AccuracySearch(resolved, resolvedError, progress).closest(runs, mostSteps, 1);
    };
    const SpringSystem system = makeSpringSystem(run.model);
    AccurateOutcome found = closest(patience * stepsPerSecond(system, resolved.settings.integrator));
    if (!found.hidesSwings || isExplicit(found.outcome.integrator)) return found;
    const auto steps = followingSteps(run.model, run.settings.damping, run.scene.duration);
    if (!steps) return found;
    resolved.settings.integrator = steps->integrator;
    return closest(steps->most);
}

AccurateOutcome runSceneToError(const SceneRun& run, double mostError, const NewFrameSink& newSink,
                                const Progress& progress) {
    SceneRun searched = run;
    if (run.settings.integrator == Integrator::Auto && !run.settings.timeStep) {
        const SimulationSettings resolved = resolvedSettings(run);
        if (isExplicit(resolved.integrator)) searched.settings = resolved;
    }
    return AccuracySearch(searched, mostError, progress).search(newSink);
}

} // namespace esm

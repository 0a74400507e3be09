#include "core/dynamics/scene_run.h"

#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <chrono>
#include <cmath>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double tooShortToTime = 0.03; // s
constexpr int mostRepeats = 5;
constexpr double progressInterval = 0.1; // s
constexpr double mostAtOnce = 16;        ///< on a whole tissue, so that a run can be stopped within a second
constexpr double mostSteps = 1e12;       // at a microsecond each, eleven days

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Steps are counted, not added up; a step that misses a time by rounding alone reaches it.
double stepReaching(double time, double timeStep) {
    return std::max(0.0, std::ceil(time / timeStep - 1e-6));
}

/// @throws InvalidModel when there are more than can be run
std::size_t stepsOf(const Scene& scene, double timeStep) {
    const double steps = std::max(1.0, stepReaching(scene.duration, timeStep));
    if (steps > mostSteps)
        throw InvalidModel("duration: " + numberText(scene.duration) + " s in steps of " +
                           numberText(timeStep) + " s are more steps than can be run, " +
                           numberText(mostSteps) + "; shorten the duration or lengthen the step");
    return static_cast<std::size_t>(steps);
}

class Recorder {
public:
    Recorder(const Scene& scene, double timeStep, FrameSink sink)
        : m_scene(scene), m_timeStep(timeStep), m_last(stepsOf(scene, timeStep)), m_sink(std::move(sink)) {}

    std::size_t lastStep() const { return m_last; }

    /// Hands out the state after so many steps when a frame is due, or when it is the last there will be.
    void offer(std::size_t step, const Simulation& simulation, bool last) {
        const bool isDue = static_cast<double>(step) >= m_next;
        if (!isDue && step != m_last && !(last && step > m_given)) return;
        if (m_sink) m_sink(simulation.time(), recorded(simulation.positions()));
        m_given = step;
        if (isDue) m_next = dueAfter(step);
    }

    /// How many more steps until something is to be handed out.
    std::size_t stepsUntilDue(std::size_t step) const {
        const double due = std::min(m_next, static_cast<double>(m_last));
        return static_cast<std::size_t>(std::max(1.0, due - static_cast<double>(step)));
    }

private:
    /// The step at which the next frame is due: each one when frames follow faster than steps.
    double dueAfter(std::size_t step) {
        if (m_scene.record.every <= m_timeStep) return static_cast<double>(step) + 1;
        return stepReaching(++m_frame * m_scene.record.every, m_timeStep);
    }

    Vectors recorded(const Vectors& positions) const {
        if (!m_scene.record.nodes) return positions;
        Vectors chosen;
        for (std::uint32_t node : *m_scene.record.nodes)
            chosen.push_back(positions[node]);
        return chosen;
    }

    const Scene& m_scene;
    double m_timeStep;
    std::size_t m_last, m_given = 0;
    double m_next = 0, m_frame = 0; ///< whole numbers; may be beyond any step
    FrameSink m_sink;
};

/// For how many steps the loads stay as they are, up to `most`. Only explicit steps are short enough to be
/// worth taking together.
std::size_t steadySteps(const Scene& scene, const Simulation& simulation, std::size_t most) {
    if (!isExplicit(simulation.integrator()) || !scene.moves.empty() || scene.instrument) return 1;
    double until = noStepLimit;
    for (const NodeForce& force : scene.forces)
        for (const double change : {force.from, force.to})
            if (change > simulation.time()) until = std::min(until, change);
    const double steps = std::floor((until - simulation.time()) / simulation.timeStep());
    return steps >= static_cast<double>(most) ? most : static_cast<std::size_t>(std::max(1.0, steps));
}

/// How many of the steps were taken; failure() says why not all.
std::size_t stepsTaken(Simulation& simulation, const Loads& loads, std::size_t wanted) {
    try {
        return simulation.advance(loads, wanted);
    } catch (const InvalidModel&) {
        return 0;
    }
}

/// Runs the scene from rest, its instrument standing at its path's start; returns the seconds spent stepping.
double stepThrough(const SceneRun& run, Simulation& simulation, Recorder& recorder, const Progress& progress,
                   SceneOutcome& outcome) {
    double stepping = 0;
    Clock::time_point lastReport = Clock::now();
    if (run.scene.instrument) simulation.placeInstrument(positionAt(run.scene.instrument->path, 0));
    recorder.offer(0, simulation, false);
    for (outcome.steps = 0; outcome.steps < recorder.lastStep();) {
        const Loads loads =
            loadsAt(run.scene, run.model.network->restPositions, simulation.time(), simulation.timeStep());
        const Clock::time_point start = Clock::now();
        const auto most = static_cast<std::size_t>(mostAtOnce / std::max(simulation.activeFraction(), 1e-3));
        const std::size_t wanted =
            steadySteps(run.scene, simulation, std::min(most, recorder.stepsUntilDue(outcome.steps)));
        const std::size_t taken = stepsTaken(simulation, loads, wanted);
        stepping += secondsSince(start);
        outcome.steps += taken;
        outcome.stable = taken == wanted;
        if (!outcome.stable) break;
        recorder.offer(outcome.steps, simulation, false);
        if (secondsSince(lastReport) < progressInterval) continue;
        lastReport = Clock::now();
        reportProgress(progress,
                       static_cast<double>(outcome.steps) / static_cast<double>(recorder.lastStep()));
    }
    if (!outcome.stable) recorder.offer(outcome.steps, simulation, true);
    return stepping;
}

/// A chosen step is shortened so that frames fall on steps, where that leaves it long enough.
SimulationSettings withStep(const SceneRun& run) {
    SimulationSettings settings = run.settings;
    if (settings.timeStep) return settings;
    const ChosenStep chosen = chooseStep(run.model, settings);
    settings.integrator = chosen.integrator;
    const double every = run.scene.record.every;
    const double shortened = every / std::ceil(every / chosen.timeStep * (1 - 1e-9));
    settings.timeStep = shortened >= shortestStep ? shortened : chosen.timeStep;
    return settings;
}

double bestOfRepeats(const SceneRun& run, Simulation& simulation, double seconds) {
    for (int repeat = 1; repeat < mostRepeats && seconds < tooShortToTime; ++repeat) {
        simulation.reset();
        SceneOutcome ignored;
        Recorder nothing(run.scene, simulation.timeStep(), {});
        seconds = std::min(seconds, stepThrough(run, simulation, nothing, {}, ignored));
    }
    return seconds;
}

} // namespace

Loads loadsAt(const Scene& scene, const Vectors& rest, double start, double timeStep) {
    Loads loads;
    loads.gravity = scene.gravity;
    const double reached = start + 1e-6 * timeStep, end = start + timeStep;
    for (const NodeForce& force : scene.forces)
        if (force.from <= reached && reached < force.to) loads.forces.emplace_back(force.node, force.force);
    for (const NodeMove& move : scene.moves)
        loads.held.push_back({move.node, rest[move.node] + positionAt(move.path, end)});
    if (scene.instrument)
        loads.instrument = Sphere{positionAt(scene.instrument->path, end), scene.instrument->radius};
    return loads;
}

SceneOutcome runScene(const SceneRun& run, const FrameSink& sink, const Progress& given) {
    if (auto problems = validate(run.scene, run.model.mass.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    double done = 0; // as told last; a step that takes long asks with it whether it is still wanted
    const Progress progress = [&](double fraction) {
        done = fraction;
        return !given || given(fraction);
    };
    reportProgress(progress, 0);
    const Clock::time_point start = Clock::now();
    SimulationSettings settings = withStep(run);
    settings.isWanted = [&] { return progress(done); };
    Simulation simulation(run.model, settings, run.scene.instrument ? run.surface : TouchedSurface());
    SceneOutcome outcome;
    outcome.setupSeconds = secondsSince(start);
    outcome.integrator = simulation.integrator();
    outcome.timeStep = simulation.timeStep();

    Recorder recorder(run.scene, outcome.timeStep, sink);
    outcome.wallSeconds = stepThrough(run, simulation, recorder, progress, outcome);
    outcome.simulatedSeconds = simulation.time();
    outcome.energy = simulation.energy();
    outcome.activeFraction = simulation.activeFraction();
    outcome.touched = simulation.wasTouched();
    outcome.outcome = outcome.stable ? "completed" : simulation.failure();
    if (outcome.stable) outcome.wallSeconds = bestOfRepeats(run, simulation, outcome.wallSeconds);
    reportProgress(progress, 1);
    return outcome;
}

} // namespace esm

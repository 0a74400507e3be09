#include "core/dynamics/scene_run.h"

#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability.h"
#include "core/support/errors.h"

#include <chrono>
#include <cmath>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double tooShortToTime = 0.01; // s
constexpr int mostRepeats = 5;
constexpr double progressInterval = 0.1; // s

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Steps are counted, not added up; a step that misses a time by rounding alone reaches it.
std::size_t stepReaching(double time, double timeStep) {
    return static_cast<std::size_t>(std::max(0.0, std::ceil(time / timeStep - 1e-6)));
}

class Recorder {
public:
    Recorder(const Scene& scene, double timeStep, FrameSink sink)
        : m_scene(scene), m_timeStep(timeStep), m_last(stepReaching(scene.duration, timeStep)),
          m_sink(std::move(sink)) {}

    std::size_t lastStep() const { return m_last; }

    /// Hands out the state after so many steps when a frame is due, or when it is the last there will be.
    void offer(std::size_t step, const Simulation& simulation, bool last) {
        if (step != m_next && step != m_last && !(last && step > m_given)) return;
        if (m_sink) m_sink(simulation.time(), recorded(simulation.positions()));
        m_given = step;
        while (m_next <= step && m_next < m_last)
            m_next = stepReaching(static_cast<double>(++m_frame) * m_scene.record.every, m_timeStep);
    }

private:
    Vectors recorded(const Vectors& positions) const {
        if (!m_scene.record.nodes) return positions;
        Vectors chosen;
        for (std::uint32_t node : *m_scene.record.nodes)
            chosen.push_back(positions[node]);
        return chosen;
    }

    const Scene& m_scene;
    double m_timeStep;
    std::size_t m_last, m_next = 0, m_given = 0, m_frame = 0;
    FrameSink m_sink;
};

/// Runs the scene from rest; returns the seconds spent stepping.
double run(Simulation& simulation, const Scene& scene, const Vectors& rest, Recorder& recorder,
           const Progress& progress, SceneOutcome& outcome) {
    double stepping = 0;
    Clock::time_point lastReport = Clock::now();
    recorder.offer(0, simulation, false);
    for (outcome.steps = 0; outcome.steps < recorder.lastStep();) {
        const Loads loads = loadsAt(scene, rest, simulation.time(), simulation.timeStep());
        const Clock::time_point start = Clock::now();
        outcome.stable = simulation.step(loads);
        stepping += secondsSince(start);
        if (!outcome.stable) break;
        recorder.offer(++outcome.steps, simulation, false);
        if (secondsSince(lastReport) < progressInterval) continue;
        lastReport = Clock::now();
        reportProgress(progress,
                       static_cast<double>(outcome.steps) / static_cast<double>(recorder.lastStep()));
    }
    if (!outcome.stable) recorder.offer(outcome.steps, simulation, true);
    return stepping;
}

/// A chosen step is shortened so that frames fall on steps.
SimulationSettings withStep(const TissueModel& model, SimulationSettings settings, const Recording& record) {
    if (settings.timeStep) return settings;
    const ChosenStep chosen = chooseStep(model, settings);
    settings.integrator = chosen.integrator;
    settings.timeStep = record.every / std::ceil(record.every / chosen.timeStep * (1 - 1e-9));
    return settings;
}

double bestOfRepeats(Simulation& simulation, const Scene& scene, const Vectors& rest, double seconds) {
    for (int repeat = 1; repeat < mostRepeats && seconds < tooShortToTime; ++repeat) {
        simulation.reset();
        SceneOutcome ignored;
        Recorder nothing(scene, simulation.timeStep(), {});
        seconds = std::min(seconds, run(simulation, scene, rest, nothing, {}, ignored));
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

SceneOutcome runScene(const TissueModel& model, const std::vector<Triangle>& surface, const Scene& scene,
                      const SimulationSettings& settings, const FrameSink& sink, const Progress& progress) {
    if (auto problems = validate(scene, model.mass.size()); !problems.empty())
        throw InvalidModel(std::move(problems));
    reportProgress(progress, 0);
    const Clock::time_point start = Clock::now();
    Simulation simulation(model, withStep(model, settings, scene.record),
                          scene.instrument ? surface : std::vector<Triangle>{});
    SceneOutcome outcome;
    outcome.setupSeconds = secondsSince(start);
    outcome.integrator = simulation.integrator();
    outcome.timeStep = simulation.timeStep();

    const Vectors& rest = model.network->restPositions;
    Recorder recorder(scene, outcome.timeStep, sink);
    outcome.wallSeconds = run(simulation, scene, rest, recorder, progress, outcome);
    outcome.simulatedSeconds = simulation.time();
    outcome.energy = simulation.energy();
    outcome.outcome = outcome.stable ? "completed" : simulation.failure();
    if (outcome.stable) outcome.wallSeconds = bestOfRepeats(simulation, scene, rest, outcome.wallSeconds);
    reportProgress(progress, 1);
    return outcome;
}

} // namespace esm

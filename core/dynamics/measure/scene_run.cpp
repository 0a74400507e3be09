#include "core/dynamics/measure/scene_run.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/measure/scene_loads.h"
#include "core/dynamics/measure/scene_stages.h"
#include "core/dynamics/measure/timeline.h"
#include "core/dynamics/measure/watched_run.h"
#include "core/dynamics/stability/stability.h"
#include "core/model/scene_cavities.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace esm {

namespace {

constexpr double tooShortToTime = 0.03;  // s
constexpr int mostRepeats = 5;           // at most 0.15 s in all
constexpr double progressInterval = 0.1; // s
constexpr double mostAtOnce = 16;        ///< on a whole tissue, so that a run can be stopped within a second
constexpr double mostSteps = 1e12;       // at a microsecond each, eleven days

/// @throws InvalidModel when there are more steps than can be run
void requireRunnable(const Scene& scene, double timeStep) {
    if (!(scene.duration / timeStep > mostSteps)) return;
    throw InvalidModel("duration: " + roundedText(scene.duration) + " s in steps of " +
                       roundedText(timeStep) + " s are more steps than can be run, " +
                       roundedText(mostSteps) + "; shorten the duration or lengthen the step");
}

/// Hands out frames at the times that a scene asks for, at the first step that reaches each. Steps are not
/// cut for frames: that would change the motion with what is looked at.
class Recorder {
public:
    Recorder(const SceneRun& run, double timeStep, FrameSink sink)
        : m_scene(run.scene), m_nodes(recordedNodes(run.scene, run.model.mass.size())), m_timeStep(timeStep),
          m_sink(std::move(sink)) {}

    /// Hands out the state at a time when a frame is due, or when it is the last there will be.
    void offer(double time, const Simulation& simulation, bool last) {
        const bool isDue = time >= m_due;
        if (!isDue && !(last && time > m_given)) return;
        if (m_sink) m_sink(time, recorded(simulation.positions()));
        recordForces(time, simulation);
        recordFluids(time, simulation);
        m_given = time;
        if (isDue) m_due = dueAfter(time);
    }

    std::vector<ForceRow> takeForces() { return std::move(m_forces); }
    std::vector<FluidRow> takeFluids() { return std::move(m_fluids); }

    /// s, when the next frame is to be handed out.
    double due() const { return m_due; }

private:
    /// A step that misses a time by rounding alone reaches it. Each is due when frames follow faster than
    /// steps.
    double dueAfter(double time) {
        constexpr double rounding = 1e-6;
        const double every = m_scene.record.every;
        if (every <= m_timeStep) return std::nextafter(time, noStepLimit);
        m_frame = std::max(m_frame + 1, std::floor((time + rounding * m_timeStep) / every) + 1);
        return m_frame * every - rounding * m_timeStep;
    }

    void recordForces(double time, const Simulation& simulation) {
        if (m_scene.instruments.empty()) return;
        const double passed = m_forces.empty() ? 0 : time - m_forces.back().time;
        m_impulses.resize(m_scene.instruments.size(), Eigen::Vector3d::Zero());
        ForceRow row{time, Vectors(m_impulses.size(), Eigen::Vector3d::Zero())};
        const std::vector<InstrumentTouch>& touches = simulation.instrumentTouches();
        for (std::size_t i = 0; i < touches.size() && passed > 0; ++i) {
            row.forces[i] = (touches[i].impulse - m_impulses[i]) / passed;
            m_impulses[i] = touches[i].impulse;
        }
        m_forces.push_back(std::move(row));
    }

    void recordFluids(double time, const Simulation& simulation) {
        const std::vector<SpringSystem::Filled>& cavities = simulation.system().cavities;
        if (cavities.empty()) return;
        FluidRow row{time, volumesOf(simulation.system(), simulation.positions()), {}};
        for (std::size_t i = 0; i < cavities.size(); ++i) {
            const PartPressure* fromScene = pressureOf(m_scene, cavities[i].part);
            row.pressures.push_back(ownPressure(cavities[i], row.volumes[i]) +
                                    (fromScene ? pressureAt(*fromScene, time) : 0));
        }
        m_fluids.push_back(std::move(row));
    }

    Vectors recorded(const Vectors& positions) const {
        if (!m_nodes) return positions;
        Vectors chosen;
        for (std::uint32_t node : *m_nodes)
            if (node < positions.size()) chosen.push_back(positions[node]);
        return chosen;
    }

    const Scene& m_scene;
    std::optional<std::vector<std::uint32_t>> m_nodes; ///< none: all
    double m_timeStep;                                 ///< s
    double m_due = 0, m_given = 0, m_frame = 0;        ///< s, s, a whole number; may be beyond any time
    FrameSink m_sink;
    std::vector<ForceRow> m_forces;
    std::vector<FluidRow> m_fluids;
    Vectors m_impulses; ///< N·s, on the instruments up to the last row
};

/// How many whole steps may be taken together. Each call copies the state and looks at where it led, which
/// explicit steps are too short to bear one by one. Loads that move would stand still meanwhile.
std::size_t mostTogether(const Scene& scene, const Simulation& simulation) {
    if (!isExplicit(simulation.integrator()) || !scene.moves.empty() || !scene.instruments.empty() ||
        !scene.pressures.empty())
        return 1;
    return static_cast<std::size_t>(mostAtOnce / std::max(simulation.activeFraction(), 1e-3));
}

/// How many of the steps were taken; failure() says why not all.
std::size_t stepsTaken(Simulation& simulation, const Loads& loads, const TimeSpan& span) {
    try {
        if (span.isWhole) return simulation.advance(loads, span.steps);
        return simulation.stepTo(span.end, loads) ? 1 : 0;
    } catch (const InvalidModel&) {
        return 0;
    }
}

double lengthOf(const TimeSpan& span) {
    return (span.end - span.start) / static_cast<double>(span.steps);
}

void count(const TimeSpan& span, std::size_t taken, SceneOutcome& outcome) {
    outcome.steps += taken;
    if (taken == 0 || span.isWhole) return;
    ++outcome.cutSteps;
    outcome.shortestStep = std::min(outcome.shortestStep, lengthOf(span));
}

/// The simulated surface, node i as its vertex i, by which a run splits what it steps. The drawn surface is
/// not asked for: a run is the same whether or not somebody draws it.
Topology steppedTopology(const SceneRun& run) {
    auto network = std::make_shared<SpringNetwork>(*run.model.network);
    network->vertexNodes.resize(network->restPositions.size());
    std::iota(network->vertexNodes.begin(), network->vertexNodes.end(), 0U);
    auto surface =
        std::make_shared<const TriangleMesh>(TriangleMesh{network->restPositions, run.surface.triangles});
    return authoredTopology(std::move(surface), std::move(network));
}

std::vector<SceneStage> laterStages(const SceneRun& run) {
    if (run.scene.splits.empty()) return {};
    return laterStages(steppedTopology(run), run.model, run.scene);
}

/// What a run steps and watches, stage by stage. The watch over energy begins anew with each stage: a split
/// changes none, but its sums hang on nodes and springs that are others then.
class StagedRun {
public:
    StagedRun(const SceneRun& run, const std::vector<SceneStage>& stages, Simulation& simulation)
        : m_run(run), m_stages(stages), m_simulation(simulation), m_settings(run.settings) {
        m_settings.integrator = simulation.integrator();
        m_watched.emplace(simulation, m_settings);
    }

    WatchedRun& watched() { return *m_watched; }
    const Scene& scene() const { return m_entered == 0 ? m_run.scene : m_stages[m_entered - 1].scene; }
    const Vectors& rest() const { return m_simulation.system().network->restPositions; }

    /// Begins the stages whose time has come; returns the seconds that took.
    double enterStages(const Timeline& timeline) {
        const auto isDue = [&] {
            return m_entered < m_stages.size() && timeline.hasReached(m_stages[m_entered].begin);
        };
        if (!isDue()) return 0;
        const double start = m_run.clock();
        for (; isDue(); ++m_entered) {
            const SplitTissue& organ = m_stages[m_entered].organ;
            m_simulation.setTopology(organ.tissue, organ.map,
                                     m_run.scene.instruments.empty() ? TouchedSurface()
                                                                     : organ.topology.surface->triangles);
            m_watched.emplace(m_simulation, m_settings);
        }
        return m_run.clock() - start;
    }

private:
    const SceneRun& m_run;
    const std::vector<SceneStage>& m_stages;
    Simulation& m_simulation;
    SimulationSettings m_settings;
    std::optional<WatchedRun> m_watched;
    std::size_t m_entered = 0;
};

/// Runs the scene from rest, its instruments standing at their paths' starts; returns the seconds spent
/// stepping and splitting.
double stepThrough(const SceneRun& run, const std::vector<SceneStage>& stages, Simulation& simulation,
                   Recorder& recorder, const Progress& progress, SceneOutcome& outcome) {
    StagedRun staged(run, stages, simulation);
    double lastReport = run.clock();
    const TimeDivision division{std::ldexp(simulation.timeStep(), run.halvings), run.halvings};
    Timeline timeline(run.scene, division, simulation.integrator(), staged.rest().size());
    outcome.averagedCorners = timeline.averagedCorners();
    std::vector<ColliderPose> starts;
    for (const InstrumentMotion& instrument : run.scene.instruments)
        starts.push_back(poseAt(instrument, 0));
    simulation.placeInstruments(std::move(starts));
    double stepping = staged.enterStages(timeline);
    recorder.offer(0, simulation, false);
    while (!timeline.isAtEnd()) {
        const TimeSpan span = timeline.next(recorder.due(), mostTogether(run.scene, simulation));
        Loads loads = loadsDuring(staged.scene(), staged.rest(), span.start, span.end);
        loads.beginsAnew = span.beginsAnew;
        staged.watched().begin();
        const double start = run.clock();
        const std::size_t taken = stepsTaken(simulation, loads, span);
        stepping += run.clock() - start;
        timeline.advance(span, taken);
        count(span, taken, outcome);
        outcome.stable = taken == span.steps;
        if (!outcome.stable) {
            outcome.outcome = simulation.failure();
            recorder.offer(timeline.time(), simulation, true);
            break;
        }
        outcome.outcome =
            staged.watched().problemAfter(loads, lengthOf(span), span.steps, timeline.isAtEnd());
        outcome.stable = outcome.outcome.empty();
        if (!outcome.stable) break;
        stepping += staged.enterStages(timeline);
        recorder.offer(timeline.time(), simulation, timeline.isAtEnd());
        if (run.clock() - lastReport < progressInterval) continue;
        lastReport = run.clock();
        reportProgress(progress, timeline.time() / run.scene.duration);
    }
    outcome.simulatedSeconds = timeline.time();
    return stepping;
}

/// A chosen step suits every stage, and is shortened so that frames fall on steps, where that leaves it long
/// enough.
SimulationSettings withStep(const SceneRun& run, const std::vector<SceneStage>& stages) {
    SimulationSettings settings = run.settings;
    if (settings.timeStep) return settings;
    ChosenStep chosen = chooseStep(run.model, settings);
    settings.integrator = chosen.integrator;
    for (const SceneStage& stage : stages)
        chosen.timeStep = std::min(chosen.timeStep, chooseStep(stage.organ.tissue, settings).timeStep);
    const double every = run.scene.record.every;
    const double shortened = every / std::ceil(every / chosen.timeStep * (1 - 1e-9));
    settings.timeStep = shortened >= shortestStep ? shortened : chosen.timeStep;
    return settings;
}

/// What else a machine does can only make a run longer. Of short ones, where that is much, the shortest of
/// some is the nearest to its own time.
double bestOfRepeats(const SceneRun& run, const std::vector<SceneStage>& stages, Simulation& simulation,
                     double seconds) {
    for (int repeat = 1; repeat < mostRepeats && seconds < tooShortToTime; ++repeat) {
        simulation.reset();
        SceneOutcome ignored;
        Recorder nothing(run, simulation.timeStep(), {});
        seconds = std::min(seconds, stepThrough(run, stages, simulation, nothing, {}, ignored));
    }
    return seconds;
}

} // namespace

double orderOfErrors(const SceneOutcome& outcome) {
    // Which node is touched when changes with the step. On an open colon each of three halvings left 0.65 to
    // 0.69 of the error.
    constexpr double touchedOrder = 0.5;
    if (outcome.touched()) return touchedOrder;
    return outcome.averagedCorners == 0 ? orderOf(outcome.integrator) : 1;
}

bool SceneOutcome::touched() const {
    return std::any_of(instruments.begin(), instruments.end(),
                       [](const InstrumentTouch& touch) { return touch.touched; });
}

InstrumentForce forceOn(std::size_t instrument, const SceneOutcome& outcome) {
    InstrumentForce force;
    double passed = 0, before = 0;
    for (const ForceRow& row : outcome.forces) {
        const double size = row.forces[instrument].norm(),
                     duration = row.time - std::exchange(before, row.time);
        force.mean += duration * size;
        force.peak = std::max(force.peak, size);
        passed += duration;
    }
    if (passed > 0) force.mean /= passed;
    return force;
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
    const double start = run.clock();
    const std::vector<SceneStage> stages = laterStages(run);
    SimulationSettings settings = withStep(run, stages);
    SceneOutcome outcome;
    outcome.timeStep = std::ldexp(*settings.timeStep, -run.halvings);
    requireRunnable(run.scene, outcome.timeStep);
    const double longest = std::ldexp(run.scene.duration, -run.halvings);
    settings.timeStep = outcome.shortestStep = std::min(outcome.timeStep, longest);
    settings.isWanted = [&] { return progress(done); };
    Simulation simulation(run.model, settings,
                          run.scene.instruments.empty() ? TouchedSurface() : run.surface);
    outcome.setupSeconds = run.clock() - start;
    outcome.factorisationSeconds = simulation.factorisationSeconds();
    outcome.integrator = simulation.integrator();

    Recorder recorder(run, simulation.timeStep(), sink);
    outcome.wallSeconds = stepThrough(run, stages, simulation, recorder, progress, outcome);
    outcome.energy = simulation.energy();
    outcome.activeFraction = simulation.activeFraction();
    outcome.instruments = simulation.instrumentTouches();
    outcome.instruments.resize(run.scene.instruments.size());
    outcome.forces = recorder.takeForces();
    outcome.fluids = recorder.takeFluids();
    if (outcome.stable) outcome.outcome = "completed";
    if (outcome.stable) outcome.wallSeconds = bestOfRepeats(run, stages, simulation, outcome.wallSeconds);
    reportProgress(progress, 1);
    return outcome;
}

} // namespace esm

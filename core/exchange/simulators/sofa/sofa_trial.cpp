#include "core/exchange/simulators/sofa/sofa_trial.h"

#include "core/dynamics/measure/motion_error.h"
#include "core/dynamics/measure/scene_accuracy.h"
#include "core/dynamics/stability/stability.h"
#include "core/exchange/simulators/sofa/sofa_run.h"
#include "core/exchange/simulators/sofa/sofa_scene.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using SofaFrames = std::vector<std::vector<Eigen::Vector3d>>; ///< m, at the start and at every record

constexpr double referenceError = 1e-4; ///< of the motion

/// The scene as SOFA runs it: to the end of its last step, with places at the same times.
Scene scheduledScene(Scene scene, const SofaSchedule& schedule) {
    scene.duration = schedule.duration();
    scene.record = {schedule.every(), std::nullopt};
    return scene;
}

/// What never falls, of several runs in turn. @param progress outlives it, as `done` does
Progress risingOf(const Progress& progress, double& done) {
    return [&](double fraction) {
        done = std::max(done, fraction);
        return !progress || progress(done);
    };
}

/// The work is done in runs of ever shorter steps, nobody knows how many: each takes half of what is left.
SofaFrames referenceFrames(const SceneRun& run, const Progress& progress) {
    SofaFrames frames;
    ProgressParts parts(progress);
    Progress part;
    double done = 0;
    const NewFrameSink newSink = [&]() -> FrameSink {
        frames.clear();
        part = parts.nextOfRest(0.5);
        done = 0;
        return
            [&frames](double, const std::vector<Eigen::Vector3d>& positions) { frames.push_back(positions); };
    };
    runSceneToError(run, referenceError, newSink, risingOf(part, done));
    return frames;
}

/// s of computing per simulated second, in the way that is recommended or else chosen.
double usualWallTime(SceneRun run, const Project& project, const Progress& progress) {
    double done = 0;
    const Progress rising = risingOf(progress, done);
    run.settings = steppedAsRecommended(run.settings, run.model, project.stepping);
    const bool isRecommended = run.settings.timeStep.has_value();
    const NewFrameSink nothing = []() -> FrameSink {
        return [](double, const std::vector<Eigen::Vector3d>&) {};
    };
    const SceneOutcome outcome =
        isRecommended ? runScene(run, {}, rising) : runSceneResolved(run, nothing, rising).outcome;
    return outcome.wallSeconds / outcome.simulatedSeconds;
}

/// @throws FileError where SOFA's times are others, as of a scene that was changed
SofaFrames framesAt(const SofaSchedule& schedule, std::vector<SofaState> states,
                    const std::filesystem::path& program) {
    constexpr double writtenDigits = 1e-5; // of a time
    SofaFrames frames;
    for (std::size_t i = 0; i <= schedule.records; ++i) {
        const double time = static_cast<double>(i) * schedule.every();
        if (std::abs(states[i].time - time) > std::max(schedule.timeStep / 2, writtenDigits * time))
            throw FileError(program, "has no state at " + roundedText(time) + " s; its next is at " +
                                         roundedText(states[i].time) +
                                         " s, so that it may be of a release whose steps are others");
        frames.push_back(std::move(states[i].positions));
    }
    return frames;
}

bool hasMotion(const SofaFrames& frames) {
    return std::any_of(frames.begin(), frames.end(),
                       [&](const auto& frame) { return frame != frames.front(); });
}

/// Of those that nothing leads: the others are in one place here and there, whatever the tissue does.
std::uint32_t farthestNode(const SofaFrames& frames, const std::vector<NodeMove>& moves) {
    std::vector<char> isLed(frames.front().size(), 0);
    for (const NodeMove& move : moves)
        isLed[move.node] = 1;
    std::uint32_t farthest = 0;
    double most = 0;
    for (const auto& frame : frames)
        for (std::size_t node = 0; node < frame.size(); ++node) {
            const double way = isLed[node] ? 0 : (frame[node] - frames.front()[node]).squaredNorm();
            if (way <= most) continue;
            most = way;
            farthest = static_cast<std::uint32_t>(node);
        }
    return farthest;
}

std::vector<double> waysOf(std::uint32_t node, const SofaFrames& frames) {
    std::vector<double> ways;
    for (const auto& frame : frames)
        ways.push_back((frame[node] - frames.front()[node]).norm());
    return ways;
}

/// What rounding took off a place. More is a way: led nodes are a step ahead as SOFA begins.
Eigen::Vector3d roundedOff(const Eigen::Vector3d& place, const Eigen::Vector3d& written) {
    constexpr double writtenDigits = 1e-5; // of a coordinate
    const Eigen::Array3d off = (place - written).array();
    return (off.abs() <= writtenDigits * place.array().abs()).select(off, 0.0);
}

/// SOFA's places with what was rounded off those at rest. Each is written alike while it stays, so that as
/// much is lost of it later.
SofaFrames fromSameRest(SofaFrames there, const std::vector<Eigen::Vector3d>& rest) {
    const std::vector<Eigen::Vector3d> written = there.front();
    for (auto& frame : there)
        for (std::size_t node = 0; node < frame.size(); ++node)
            frame[node] += roundedOff(rest[node], written[node]);
    return there;
}

/// What both motions come to.
SofaTrial comparedTrial(const SofaFrames& here, const SofaFrames& there, const SofaSchedule& schedule,
                        const std::vector<NodeMove>& moves) {
    MotionError error;
    for (std::size_t i = 1; i < here.size(); ++i)
        error.add(there[i], here[i], here.front());
    const std::uint32_t farthest = farthestNode(here, moves);
    SofaTrial trial;
    trial.error = error.relative();
    trial.timeStep = schedule.timeStep;
    trial.here = waysOf(farthest, here);
    trial.there = waysOf(farthest, there);
    for (std::size_t i = 0; i < here.size(); ++i)
        trial.times.push_back(static_cast<double>(i) * schedule.every());
    return trial;
}

} // namespace

SofaTrial tryInSofa(const std::filesystem::path& program, Project project, const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    project.scene = sceneInSofa(std::move(project.scene));
    const Handover handover = handoverOf(project, parts.next(0.02));
    const double timeStep = sofaStep(handover.tissue, means.engine, parts.next(0.03));
    const SofaSchedule schedule = sofaSchedule(project.scene.duration, timeStep);
    const Scene scene = scheduledScene(project.scene, schedule);
    SimulationSettings settings;
    settings.damping = means.engine.damping;
    const SceneRun run{handover.tissue, {}, scene, settings};
    const SofaFrames here = referenceFrames(run, parts.next(0.4));
    if (here.size() != schedule.records + 1)
        throw InvalidModel("the motion here has " + std::to_string(here.size()) + " states and not " +
                           std::to_string(schedule.records + 1) + "; choose another time step");
    if (!hasMotion(here))
        throw InvalidModel("nothing moves the organ; record a poke and pull at it, or give its scene a force "
                           "on a node that is not fixed");
    const double wallHere = usualWallTime(run, project, parts.next(0.1));
    HandoverMeans stepped = withProgress(means, parts.rest());
    stepped.engine.timeStep = timeStep;
    SofaRun sofa = runInSofa(program, handover, stepped, schedule);
    const SofaFrames there = framesAt(schedule, std::move(sofa.states), program);
    SofaTrial trial = comparedTrial(here, fromSameRest(there, here.front()), schedule, movesOf(handover));
    trial.wallHere = wallHere;
    trial.wallThere = sofa.wallPerSimulatedSecond;
    return trial;
}

} // namespace esm

#include "core/dynamics/detail_error.h"

#include "core/dynamics/motion_error.h"
#include "core/dynamics/scene_run.h"
#include "core/model/detail_change.h"
#include "core/support/errors.h"

namespace esm {

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The drawn vertices at the recorded times, and the run's time step.
struct DrawnMotion {
    std::vector<Points> frames;
    double timeStep = 0;
};

DrawnMotion motionOf(const Project& project, const SimulationSettings& settings, const Progress& progress) {
    Scene scene = project.scene;
    scene.record.nodes.reset();
    DrawnMotion motion;
    const auto keep = [&](double, const Points& positions) {
        motion.frames.push_back(drawnPositions(*project.mesh, *project.network, positions));
    };
    const TouchedSurface surface = touchedSurface(*project.mesh, *project.network);
    const TissueModel model = evaluateModel(project, scene);
    const SceneOutcome outcome = runScene({model, surface, scene, settings}, keep, progress);
    if (!outcome.stable)
        throw InvalidModel("with " + std::to_string(model.mass.size()) +
                           " nodes the run stopped: " + outcome.outcome);
    motion.timeStep = outcome.timeStep;
    return motion;
}

} // namespace

double detailError(const Project& project, const Detail& detail, const SimulationSettings& settings,
                   const Progress& progress) {
    const Project fewer = withDetail(project, detail);
    const auto half = [&](double from) {
        return [&, from](double fraction) { return !progress || progress(from + fraction / 2); };
    };
    const DrawnMotion full = motionOf(project, settings, half(0));
    SimulationSettings sameSteps = settings;
    sameSteps.timeStep = full.timeStep;
    const DrawnMotion coarse = motionOf(fewer, sameSteps, half(0.5));
    MotionError error;
    for (std::size_t frame = 0; frame < full.frames.size(); ++frame)
        error.add(coarse.frames.at(frame), full.frames[frame], full.frames.front());
    return error.relative();
}

} // namespace esm

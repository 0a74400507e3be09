#include "app/editor/commands/accuracy_measurement.h"

#include "app/editor/preview/grasp.h"
#include "core/dynamics/coarser_runs.h"
#include "core/support/errors.h"

namespace esm {

namespace {

bool movesTissue(const Scene& scene) {
    return !scene.forces.empty() || !scene.moves.empty() || scene.instrument || !scene.gravity.isZero();
}

Scene pullAtTheEdge(const Project& project) {
    const TissueModel model = evaluateModel(project);
    const auto pull = gentlePull(model);
    if (!pull) throw InvalidModel("every node is fixed: nothing can move");
    Scene scene = project.scene;
    scene.duration = 1;
    scene.record = {0.02, {}};
    for (const std::uint32_t node : graspedNodes(model, pull->node))
        scene.moves.push_back({node, {{0, Eigen::Vector3d::Zero()}, {0.5, pull->furthest}}});
    return scene;
}

} // namespace

Scene measuredScene(const Project& project) {
    return movesTissue(project.scene) ? project.scene : pullAtTheEdge(project);
}

Tradeoff measureAccuracy(const Project& project, const TradeoffOptions& options, const Progress& progress) {
    const Scene scene = measuredScene(project);
    const TissueModel model = evaluateModel(project, scene);
    const TouchedSurface surface = touchedSurface(*project.mesh, *project.network);
    TradeoffOptions all = options;
    all.coarser = coarserRuns(project, scene, progress);
    return measureTradeoff({model, surface, scene}, all, progress);
}

} // namespace esm

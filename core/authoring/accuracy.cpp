#include "core/authoring/accuracy.h"

#include "core/authoring/coarser_runs.h"
#include "core/model/gentle_pull.h"

namespace esm {

Scene measuredScene(const Project& project) {
    return movesTissue(project.scene) ? project.scene : withGentlePull(evaluateModel(project), project.scene);
}

Tradeoff measureAccuracy(const Project& project, const TradeoffOptions& options, const Progress& progress) {
    const Scene scene = measuredScene(project);
    const TissueModel model = evaluateModel(project, scene);
    const TouchedSurface surface = touchedSurface(*project.mesh, *project.network);
    TradeoffOptions all = options;
    ProgressParts parts(progress);
    all.coarser = coarserRuns(project, scene, parts.next(0.05));
    return measureTradeoff({model, surface, scene}, all, parts.rest());
}

} // namespace esm

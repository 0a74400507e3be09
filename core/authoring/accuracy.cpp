#include "core/authoring/accuracy.h"

#include "core/authoring/coarser_runs.h"
#include "core/model/gentle_pull.h"
#include "core/model/tissue_digest.h"
#include "core/project/detail_change.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"

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

Project withAccuracy(const Project& project, const Scene& scene, const Tradeoff& measured) {
    Project changed = project;
    changed.accuracy = std::make_shared<const MeasuredAccuracy>(measuredAccuracy(
        {tissueDigest(evaluateModel(project)), scene}, detailOf(*project.network), measured));
    return changed;
}

MeasuredOrgan measuredOrgan(const Project& project) {
    return {tissueDigest(evaluateModel(project)), project.scene};
}

bool isMeasuredOn(const Project& project, const MeasuredOrgan& organ) {
    return organ == project.accuracy->organ || organ == project.accuracy->onFewerNodes;
}

namespace {

/// What a scene says of nodes goes to others where these become fewer, and does not come back the same: the
/// scene that was measured takes its place. What was edited since has no other scene than its own.
Project onMeasuredNodes(const Project& project, const MeasuredOrgan& organ, const Progress& progress) {
    const MeasuredAccuracy& accuracy = *project.accuracy;
    if (detailOf(*project.network) == accuracy.detail) return project;
    Project measured = withDetail(project, accuracy.detail, progress);
    if (organ != accuracy.onFewerNodes) return measured;
    measured.scene = accuracy.organ.scene;
    std::vector<std::string> problems;
    addUnder(problems, "the scene that was measured",
             validate(measured.scene, measured.network->restPositions.size()));
    if (!problems.empty()) throw InvalidModel(std::move(problems));
    return measured;
}

} // namespace

Project withMeasuredRun(const Project& project, std::size_t run, const Progress& progress) {
    reportProgress(progress, 0);
    const MeasuredAccuracy& accuracy = *project.accuracy;
    const MeasuredOrgan organ = measuredOrgan(project);
    ProgressParts parts(progress);
    const Project measured = onMeasuredNodes(project, organ, parts.next(0.5));
    Project changed = withRun(measured, accuracy.runs[run], parts.rest());
    if (!isMeasuredOn(project, organ)) return changed;
    auto holding = std::make_shared<MeasuredAccuracy>(accuracy);
    holding->onFewerNodes.reset();
    if (accuracy.runs[run].coarser) holding->onFewerNodes = measuredOrgan(changed);
    changed.accuracy = std::shared_ptr<const MeasuredAccuracy>(std::move(holding));
    return changed;
}

} // namespace esm

#include "core/exchange/simulators/handover.h"
#include "core/authoring/packing.h"

namespace esm {

Handover handoverOf(const Project& project, const Progress& progress) {
    reportProgress(progress, 0);
    Handover handover{project, soundModel(project)};
    const TriangleMesh& mesh = *project.mesh;
    if (mesh.triangles.empty())
        handover.project.atlas = nullptr;
    else if (!project.atlas && (!project.layers.empty() || project.texture.occlusionReach > 0))
        pack(handover.project, progress);
    reportProgress(progress, 1);
    return handover;
}

HandoverMeans withProgress(HandoverMeans means, Progress progress) {
    means.progress = std::move(progress);
    return means;
}

} // namespace esm

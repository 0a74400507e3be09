#include "core/exchange/simulators/handover.h"

#include "core/authoring/packing.h"

#include <algorithm>
#include <iterator>

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

std::vector<NodeMove> movesOf(const Handover& handover) {
    std::vector<NodeMove> moves;
    const std::vector<std::uint32_t>& fixed = handover.tissue.fixedNodes;
    std::copy_if(handover.project.scene.moves.begin(), handover.project.scene.moves.end(),
                 std::back_inserter(moves), [&](const NodeMove& move) {
                     return move.node < handover.tissue.mass.size() &&
                            !std::binary_search(fixed.begin(), fixed.end(), move.node);
                 });
    return moves;
}

} // namespace esm

#include "core/exchange/simulators/handover.h"
#include "core/authoring/packing.h"

namespace esm {

Handover handoverOf(const Project& project) {
    Handover handover{project, soundModel(project)};
    const TriangleMesh& mesh = *project.mesh;
    if (mesh.triangles.empty())
        handover.project.atlas = nullptr;
    else if (!project.atlas && !project.layers.empty())
        pack(handover.project);
    return handover;
}

} // namespace esm

#include "core/exchange/simulators/handover.h"
#include "core/authoring/packing.h"

#include "core/support/errors.h"

namespace esm {

namespace {

void refuse(std::vector<std::string> problems) {
    if (!problems.empty()) throw InvalidModel(std::move(problems));
}

} // namespace

Handover handoverOf(const Project& project) {
    refuse(validate(project));
    Handover handover{project, evaluateModel(project)};
    refuse(validate(handover.tissue));
    const TriangleMesh& mesh = *project.mesh;
    if (mesh.triangles.empty())
        handover.project.atlas = nullptr;
    else if (!project.atlas && !project.layers.empty())
        pack(handover.project);
    return handover;
}

} // namespace esm

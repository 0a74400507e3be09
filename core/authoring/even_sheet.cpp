#include "core/authoring/even_sheet.h"

#include "core/project/simulated_network.h"

namespace esm {

bool canBeEvenSheet(const Project& project) {
    const Detail::Kind kind = detailOf(*project.network).kind;
    const bool isSurface = kind == Detail::Kind::EveryVertex || kind == Detail::Kind::Nodes;
    return isSurface && !project.mesh->triangles.empty();
}

Project withEvenSheet(const Project& project, bool isEven, const Progress& progress) {
    auto network = std::make_shared<SpringNetwork>(*project.network);
    network->sheet.reset();
    if (isEven) network->sheet = evenSheetOf(*project.mesh, *network, progress);
    Project changed = project;
    changed.network = std::move(network);
    changed.stepping.reset();
    changed.accuracy = nullptr;
    reportProgress(progress, 1);
    return changed;
}

} // namespace esm

#include "core/exchange/simulators/obj_folder.h"

#include "core/exchange/simulators/look_differences.h"
#include "core/exchange/simulators/model_csv.h"
#include "core/exchange/simulators/obj_surface.h"
#include "core/support/new_folder.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

std::string networkObj(const SpringNetwork& network) {
    std::string text;
    for (const Eigen::Vector3d& node : network.restPositions)
        text += "v " + exactText(node.x()) + ' ' + exactText(node.y()) + ' ' + exactText(node.z()) + '\n';
    for (const Spring& spring : network.springs)
        text += "l " + std::to_string(spring.first + 1) + ' ' + std::to_string(spring.second + 1) + '\n';
    for (std::size_t node = 1; network.springs.empty() && node <= network.restPositions.size(); ++node)
        text += "p " + std::to_string(node) + '\n';
    return text;
}

void writeTables(const Handover& handover, const std::filesystem::path& folder, const Progress& progress) {
    const std::vector<ModelTable> tables = modelTables(handover);
    ProgressParts parts(progress);
    const double share = 1 / static_cast<double>(tables.size());
    for (const ModelTable& table : tables)
        writeFileAtomically(folder / (table.name + ".csv"), csvOf(table, parts.next(share)));
}

} // namespace

void writeObjFolder(const Handover& handover, const std::filesystem::path& folder,
                    const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    NewFolder written(folder);
    writeTables(handover, written.unfinished(), parts.next(handover.project.atlas ? 0.2 : 0.7));
    const HandoverMeans rest = withProgress(means, parts.nextOfRest(0.95));
    if (handover.project.mesh->triangles.empty())
        writeFileAtomically(written.unfinished() / "network.obj", networkObj(*handover.tissue.network));
    else
        writeObjSurface(handover.project, written.unfinished(), rest);
    reportProgress(parts.rest(), 1);
    written.commit();
}

Differences objFolderDifferences(const Handover& handover, const HandoverMeans& /*means*/) {
    Differences differences;
    differences.list = lookDifferences(handover.project, "an MTL");
    return differences;
}

} // namespace esm

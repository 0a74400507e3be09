#include "app/esmc/model_report.h"

#include "app/esmc/filling_report.h"
#include "core/geometry/adjacency.h"
#include "core/geometry/open_borders.h"
#include "core/model/detail.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace esm {

namespace {

double totalMass(const TissueModel& tissue) {
    return std::accumulate(tissue.mass.begin(), tissue.mass.end(), 0.0);
}

std::string repairsInText(const RepairReport& repairs) {
    return "repairs: " + counted(repairs.mergedVertices, "vertex", "vertices") + " merged, " +
           counted(repairs.splitPolygons, "polygon") + " split, " +
           counted(repairs.removedTriangles(), "triangle") + " removed, " +
           counted(repairs.flippedTriangles, "triangle") + " turned, " +
           counted(repairs.unusedVertices, "unused vertex", "unused vertices") + " dropped, " +
           counted(repairs.closedSlitEdges, "border edge") + " of slits closed, " +
           counted(repairs.filledHoles, "hole") + " of " + counted(repairs.filledHoleEdges, "border edge") +
           " filled";
}

void addSurface(Report& report, const RepairReport& repairs) {
    Json& json = report.json;
    json["merged_vertices"] = repairs.mergedVertices;
    json["removed_triangles"] = repairs.removedTriangles();
    json["components"] = repairs.components;
    json["boundary_edges"] = repairs.boundaryEdgesBefore;
    json["boundary_edges_found"] = repairs.boundaryEdgesFound();
    json["non_manifold_edges"] = repairs.nonManifoldEdgesBefore;
    json["boundary_edges_final"] = repairs.boundaryEdges;
    json["non_manifold_edges_final"] = repairs.nonManifoldEdges;
    json["inconsistent_edges"] = repairs.inconsistentEdges;
    report.text.push_back(counted(repairs.components, "part") + ", " +
                          counted(repairs.boundaryEdges, "border edge") + ", " +
                          counted(repairs.nonManifoldEdges, "edge") + " of more than two triangles");
}

/// More are told of by their number alone.
constexpr std::size_t mostBordersListed = 20;

void addOpenBorders(Report& report, const TriangleMesh& mesh) {
    const std::vector<OpenBorder> borders = openBordersOf(mesh);
    Json& list = report.json["open_borders"] = Json::array();
    for (std::size_t i = 0; i < std::min(borders.size(), mostBordersListed); ++i) {
        const double gap = borders[i].gap;
        list.push_back({{"edges", borders[i].loop.size()},
                        {"length", borders[i].length},
                        {"gap", std::isfinite(gap) ? Json(gap) : Json()}});
    }
    const std::size_t loose = countEdges(sidesByEdge(mesh.triangles)).boundary - edgesOf(borders);
    report.json["loose_border_edges"] = loose;
    if (loose > 0)
        report.text.push_back(counted(loose, "border edge") + " around no hole, which cannot be filled");
    if (borders.empty()) return;
    const OpenBorder& largest = borders.front();
    report.text.push_back(
        counted(borders.size(), "open border") + ", the largest of " + counted(largest.loop.size(), "edge") +
        ", " + inText(largest.length) + " m long" +
        (std::isfinite(largest.gap) ? ", its sides " + inText(largest.gap) + " m apart" : ""));
}

void addRepairs(Report& report, const RepairReport& repairs) {
    Json& json = report.json;
    json["degenerate_triangles"] = repairs.degenerateTriangles;
    json["duplicate_triangles"] = repairs.duplicateTriangles;
    json["split_polygons"] = repairs.splitPolygons;
    json["flipped_triangles"] = repairs.flippedTriangles;
    json["unused_vertices"] = repairs.unusedVertices;
    json["dropped_parts"] = repairs.droppedParts;
    json["closed_slit_edges"] = repairs.closedSlitEdges;
    json["filled_holes"] = repairs.filledHoles;
    json["filled_hole_edges"] = repairs.filledHoleEdges;
    json["refused_holes"] = repairs.refusedHoles;
    json["dropped_part_edges"] = repairs.droppedPartEdges;
    report.text.push_back(repairsInText(repairs));
}

/// How much of what is drawn is simulated.
void addDetail(Report& report, const TriangleMesh& mesh, const SpringNetwork& network) {
    const std::string drawn = counted(mesh.vertices.size(), "drawn vertex", "drawn vertices");
    report.json["vertices"] = mesh.vertices.size();
    report.json["even_sheet"] = network.sheet.has_value();
    if (network.sheet) report.text.emplace_back("springs: shares of an even sheet");
    switch (const Detail detail = detailOf(network); detail.kind) {
    case Detail::Kind::EveryVertex:
        report.json["detail"] = Json();
        return;
    case Detail::Kind::Nodes:
        report.json["detail"] = detail.nodes;
        report.text.push_back("detail: " + counted(detail.nodes, "node") + " carry " + drawn);
        return;
    case Detail::Kind::Filled:
        report.json["detail"] = Json::object();
        addFilling(report.json["detail"], *detail.filling);
        report.json["detail"]["tetrahedra"] = network.lattice->tetrahedra.size();
        if (isWall(*detail.filling)) addWall(report, network, mesh.triangles.size());
        report.text.push_back("inside: " + fillingText(*detail.filling) + ", " +
                              counted(network.lattice->tetrahedra.size(), "tetrahedron", "tetrahedra") +
                              "; its nodes carry " + drawn);
        return;
    case Detail::Kind::Rigid:
        report.json["detail"] = "rigid";
        report.text.push_back("detail: rigid, the springs move " + drawn + " as one piece");
    }
}

/// A package's surface was repaired before it was written: there is nothing to tell of it.
enum class Repairs { Told, Left };

Report reportOf(const TriangleMesh& mesh, const TissueModel& tissue, const RepairReport& repairs,
                Repairs telling) {
    const SpringNetwork& network = *tissue.network;
    const Eigen::AlignedBox3d box = organBox(mesh, network);
    const Eigen::Vector3d size = box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.sizes());
    const Eigen::Vector3d centre = box.isEmpty() ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(box.center());
    Report report;
    report.json["nodes"] = network.restPositions.size();
    report.json["springs"] = network.springs.size();
    report.json["triangles"] = mesh.triangles.size();
    report.text.push_back(counted(network.restPositions.size(), "node") + ", " +
                          counted(network.springs.size(), "spring") + ", " +
                          counted(mesh.triangles.size(), "triangle"));
    addDetail(report, mesh, network);
    addSurface(report, repairs);
    addOpenBorders(report, mesh);
    if (telling == Repairs::Told) addRepairs(report, repairs);
    report.json["size"] = inJson(size);
    report.json["centre"] = inJson(centre);
    report.json["mass"] = totalMass(tissue);
    report.text.push_back("size " + inText(size) + " m; centre " + inText(centre) + " m; mass " +
                          inText(totalMass(tissue)) + " kg");
    std::vector<std::string> warnings = repairs.warnings;
    if (std::string thin = thinWallWarning(network, mesh.triangles.size()); !thin.empty())
        warnings.push_back(std::move(thin));
    addWarnings(report, warnings);
    return report;
}

RepairReport countedAnew(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return {};
    PolygonSoup soup;
    soup.vertices = mesh.vertices;
    for (const Triangle& triangle : mesh.triangles)
        soup.polygons.emplace_back(triangle.begin(), triangle.end());
    return repair(soup).report;
}

} // namespace

Report modelReport(const Project& project) {
    Report report = reportOf(*project.mesh, evaluateModel(project), *project.importReport, Repairs::Told);
    report.json["own_layout"] = !project.mesh->textureCoordinates.empty();
    if (!project.mesh->textureCoordinates.empty())
        report.text.emplace_back(
            "texture coordinates of its own: texture pack --layout own lays photos by them");
    return report;
}

Report modelReport(const ModelPackage& package) {
    return reportOf(package.mesh, package.tissue, countedAnew(package.mesh), Repairs::Left);
}

void addSpringLaw(Report& report, const std::optional<SpringStiffening>& stiffening) {
    if (!stiffening) {
        report.json["stiffening"] = nullptr;
        report.text.emplace_back("springs: linear");
        return;
    }
    report.json["stiffening"] = {{"strain", stiffening->strain}, {"factor", stiffening->factor}};
    report.text.push_back("springs: biphasic, " + inText(stiffening->factor) +
                          " times as stiff once lengthened by more than " + inText(100 * stiffening->strain) +
                          " %");
}

Report saveAndReport(const Project& project, const ProjectOutput& output) {
    output.save(project);
    Report report = modelReport(project);
    addWritten(report, output.file());
    return report;
}

} // namespace esm

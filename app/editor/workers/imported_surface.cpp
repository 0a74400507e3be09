#include "app/editor/workers/imported_surface.h"

#include "core/geometry/adjacency.h"
#include "core/solid/self_intersections.h"
#include "core/texture/atlas/own_layout.h"

#include <algorithm>

namespace esm {

namespace {

std::vector<SurfacePart> partsOf(const TriangleMesh& mesh) {
    const Parts parts = connectedParts(mesh.triangles, mesh.vertices.size());
    std::vector<SurfacePart> found(parts.count);
    std::vector<Eigen::AlignedBox3d> boxes(parts.count);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = parts.ofTriangle[i];
        ++found[part].triangles;
        for (const std::uint32_t vertex : mesh.triangles[i])
            boxes[part].extend(mesh.vertices[vertex]);
    }
    for (std::size_t part = 0; part < found.size(); ++part)
        found[part].extent = boxes[part].sizes();
    std::stable_sort(found.begin(), found.end(),
                     [](const SurfacePart& a, const SurfacePart& b) { return a.triangles > b.triangles; });
    return found;
}

} // namespace

ImportedSurface importedSurface(const PolygonSoup& soup, const RepairOptions& options,
                                const Progress& progress) {
    ProgressParts parts(progress);
    RepairedMesh repaired = repair(soup, options, parts.next(0.75));
    auto mesh = std::make_shared<const TriangleMesh>(std::move(repaired.mesh));
    ImportedSurface surface{
        mesh, boundingBox(mesh->vertices).sizes(), std::move(repaired.report), partsOf(*mesh), {}, 0, {}};
    reportProgress(parts.next(0.1), 1);
    surface.borders = openBordersOf(*mesh);
    surface.meetingPairs = selfIntersectionsOf(*mesh, parts.next(0.08)).pairs;
    if (!mesh->textureCoordinates.empty()) surface.coordinateProblems = ownLayoutProblems(*mesh);
    reportProgress(progress, 1);
    return surface;
}

} // namespace esm

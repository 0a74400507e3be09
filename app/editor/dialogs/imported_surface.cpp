#include "app/editor/dialogs/imported_surface.h"

#include "core/geometry/adjacency.h"

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

ImportedSurface importedSurface(const PolygonSoup& soup, KeepParts keep) {
    RepairOptions options;
    options.keep = keep;
    const RepairedMesh repaired = repair(soup, options);
    return {boundingBox(repaired.mesh.vertices).sizes(), repaired.mesh.vertices.size(), repaired.report,
            partsOf(repaired.mesh)};
}

} // namespace

std::pair<ImportedSurface, std::optional<ImportedSurface>> waysToImport(const PolygonSoup& soup) {
    const ImportedSurface all = importedSurface(soup, KeepParts::All);
    if (all.parts.size() <= 1) return {all, std::nullopt};
    return {all, importedSurface(soup, KeepParts::Largest)};
}

} // namespace esm

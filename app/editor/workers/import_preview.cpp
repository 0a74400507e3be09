#include "app/editor/workers/import_preview.h"

#include "core/geometry/adjacency.h"
#include "core/model/spring_network.h"

#include <numeric>

namespace esm {

namespace {

/// Every vertex is a node; the borders' edges alone are springs, so that they can be marked like a region's.
std::shared_ptr<const SpringNetwork> borderNetwork(const TriangleMesh& mesh) {
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = mesh.vertices;
    network->vertexNodes.resize(mesh.vertices.size());
    std::iota(network->vertexNodes.begin(), network->vertexNodes.end(), 0U);
    forEachEdge(sidesByEdge(mesh.triangles), [&](auto side, auto end) {
        if (end - side != 1) return;
        const auto [first, second] = side->edge;
        network->springs.push_back({first, second, (mesh.vertices[first] - mesh.vertices[second]).norm()});
    });
    return network;
}

/// Bright in either theme, since it lies on the organ.
constexpr Colour borderColour{227, 163, 59};

MarkedNodes markedBorders(const SpringNetwork& network) {
    auto weights = std::make_shared<std::vector<double>>(network.restPositions.size(), 0);
    for (const Spring& spring : network.springs)
        (*weights)[spring.first] = (*weights)[spring.second] = 1;
    return {std::move(weights), borderColour};
}

} // namespace

RenderScene importPreview(const ImportedSurface& surface, LengthUnit unit, UpAxis up) {
    auto mesh = std::make_shared<TriangleMesh>(*surface.mesh);
    convertToMetres(mesh->vertices, unit, up);
    RenderScene scene;
    scene.mesh = mesh;
    if (surface.report.boundaryEdges > 0) {
        scene.network = borderNetwork(*mesh);
        scene.marked = markedBorders(*scene.network);
    }
    return scene;
}

} // namespace esm

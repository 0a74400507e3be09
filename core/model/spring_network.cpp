#include "core/model/spring_network.h"

#include <numeric>

namespace esm {

SpringNetwork networkFromMesh(const TriangleMesh& mesh) {
    SpringNetwork network;
    network.restPositions = mesh.vertices;
    for (const Edge& edge : uniqueEdges(mesh.triangles)) {
        const double length = (mesh.vertices[edge.first] - mesh.vertices[edge.second]).norm();
        network.springs.push_back({edge.first, edge.second, length});
    }
    network.vertexNodes.resize(mesh.vertices.size());
    std::iota(network.vertexNodes.begin(), network.vertexNodes.end(), 0U);
    return network;
}

} // namespace esm

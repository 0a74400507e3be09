#include "core/model/spring_network.h"

#include "core/support/offenders.h"

#include <numeric>

namespace esm {

// Every edge becomes a spring [R 2.3.7, 4.1], those too by which polygons were split: without its diagonal a
// square would be free to shear. Rest lengths are those of the mesh. The organ is then at rest as it was
// drawn, and no spring has tension.
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

// Vertices are moved by what their nodes moved by, not put where these are: a vertex may lie beside its node.
// By a binding several nodes carry each vertex.
std::vector<Eigen::Vector3d> drawnPositions(const TriangleMesh& mesh, const SpringNetwork& network,
                                            const std::vector<Eigen::Vector3d>& nodePositions) {
    if (network.binding)
        return carried(mesh.vertices, *network.binding, network.restPositions, nodePositions);
    std::vector<Eigen::Vector3d> positions = mesh.vertices;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::uint32_t node = network.vertexNodes[i];
        positions[i] += nodePositions[node] - network.restPositions[node];
    }
    return positions;
}

// Of what is seen: nodes of the stiff piece stand outside the organ, and would make it look larger.
Eigen::AlignedBox3d organBox(const TriangleMesh& mesh, const SpringNetwork& network) {
    return boundingBox(mesh.triangles.empty() ? network.restPositions : mesh.vertices);
}

// Several vertices may hang on one node. Triangles whose corners do have shrunk to a line or a point and
// cannot be touched.
std::vector<Triangle> simulatedSurface(const TriangleMesh& mesh, const SpringNetwork& network) {
    if (network.lattice) return network.lattice->surface;
    if (network.binding) return network.binding->surface;
    std::vector<Triangle> surface;
    surface.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        const Triangle nodes{network.vertexNodes[triangle[0]], network.vertexNodes[triangle[1]],
                             network.vertexNodes[triangle[2]]};
        const bool hasArea = nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0];
        if (hasArea) surface.push_back(nodes);
    }
    return surface;
}

std::vector<std::string> carryingProblems(const TriangleMesh& mesh, const SpringNetwork& network) {
    std::vector<std::string> problems;
    if (network.vertexNodes.size() != mesh.vertices.size())
        problems.push_back(std::to_string(network.vertexNodes.size()) + " of the mesh's " +
                           std::to_string(mesh.vertices.size()) + " vertices are tied to nodes");
    if (network.lattice) {
        if (!network.binding)
            problems.emplace_back("nothing binds the drawn surface to the lattice that fills it");
        addUnder(problems, "the lattice",
                 validate(*network.lattice, network.restPositions, network.springs.size()));
    }
    if (network.sheet)
        addUnder(problems, "the sheet",
                 validate(*network.sheet, network.springs.size(), network.restPositions.size()));
    if (!network.binding) return problems;
    for (std::string& problem :
         validate(*network.binding, mesh.vertices.size(), network.restPositions.size()))
        problems.push_back(std::move(problem));
    return problems;
}

} // namespace esm

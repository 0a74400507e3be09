#include "core/solid/prism_wall.h"

#include "core/solid/prism_springs.h"
#include "core/solid/wall_offsets.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

using Eigen::Vector3d;

/// A surface of which triangles use every vertex.
struct UsedSurface {
    TriangleMesh mesh;
    std::vector<std::uint32_t> numbers; ///< per vertex of the whole; 0 of one that is not used
};

UsedSurface usedSurface(const TriangleMesh& mesh) {
    std::vector<char> isUsed(mesh.vertices.size(), 0);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            isUsed[vertex] = 1;
    UsedSurface used{{{}, mesh.triangles, {}}, std::vector<std::uint32_t>(mesh.vertices.size(), 0)};
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i] == 0) continue;
        used.numbers[i] = static_cast<std::uint32_t>(used.mesh.vertices.size());
        used.mesh.vertices.push_back(mesh.vertices[i]);
    }
    for (Triangle& triangle : used.mesh.triangles)
        for (std::uint32_t& vertex : triangle)
            vertex = used.numbers[vertex];
    return used;
}

void checkWall(const TriangleMesh& mesh, const LatticeFilling& filling) {
    const std::vector<std::string> problems = fieldProblems(filling);
    if (!problems.empty()) throw InvalidModel(problems);
    if (mesh.triangles.empty()) throw InvalidModel("there is no surface to put a wall beneath");
}

void refuseTooManyNodes(double nodes) {
    if (nodes > mostLatticeNodes)
        throw InvalidModel(
            "a wall in so many layers has " + roundedText(nodes / 1e6, 4) + " million nodes; " +
            roundedText(mostLatticeNodes / 1e6, 2) +
            " million are the most: choose fewer layers or make the surface coarser at import");
}

} // namespace

double meanEdgeOf(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return 0;
    double sum = 0;
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            sum += (mesh.vertices[triangle[i]] - mesh.vertices[triangle[(i + 1) % 3]]).norm();
    return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

// Of one layer a wall bends three times as stiffly as it should, and of layers much taller than triangles are
// wide the diagonals lie along it so little that it gives way (docs/prism-walls.md).
int usualLayers(double meanEdge, double wallThickness) {
    if (!isPositive(meanEdge) || !isPositive(wallThickness)) return 2;
    constexpr double tallest = 0.75; // of a prism, over the mean edge
    return static_cast<int>(
        std::clamp(std::ceil(wallThickness / (tallest * meanEdge)), 2.0, double{mostWallLayers}));
}

int usualLayers(const TriangleMesh& mesh, double wallThickness) {
    return usualLayers(meanEdgeOf(mesh), wallThickness);
}

LatticeEstimate estimateWall(const TriangleMesh& mesh, const LatticeFilling& filling) {
    checkWall(mesh, filling);
    const UsedSurface used = usedSurface(mesh);
    const auto vertices = static_cast<double>(used.mesh.vertices.size()),
               edges = static_cast<double>(uniqueEdges(mesh.triangles).size()),
               triangles = static_cast<double>(mesh.triangles.size());
    const double layers = filling.layers, nodes = vertices * (layers + 1);
    constexpr double bytesPerNode = 2000;
    return {nodes, edges * (2 * layers + 1) + vertices * layers, 3 * triangles * layers, bytesPerNode * nodes,
            filling.wallThickness};
}

PrismWall prismWall(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress) {
    reportProgress(progress, 0);
    refuseTooManyNodes(estimateWall(mesh, filling).nodes);
    ProgressParts parts(progress);
    UsedSurface used = usedSurface(mesh);
    const WallOffsets offsets = wallOffsets(used.mesh, filling, parts.next(0.5));
    PrismWall wall;
    wall.nodes = wallNodes(used.mesh.vertices, offsets, filling.layers);
    for (int layer = 0; layer < filling.layers; ++layer)
        for (std::size_t i = 0; i < offsets.isLeftOut.size(); ++i) {
            if (offsets.isLeftOut[i] != 0) continue;
            const auto prism =
                prismOf(used.mesh.triangles[i], offsets.order, static_cast<std::uint32_t>(layer),
                        static_cast<std::uint32_t>(used.mesh.vertices.size()));
            wall.tetrahedra.insert(wall.tetrahedra.end(), prism.begin(), prism.end());
        }
    wall.springs = prismSprings(wall.nodes, used.mesh.triangles, offsets.order, filling, parts.rest());
    wall.vertexNodes = std::move(used.numbers);
    wall.shortened = offsets.shortened;
    wall.leastThickness = offsets.least;
    return wall;
}

// Files keep the nodes of a wall and what was asked for, not how it came out: it is measured again from them.
WallFit wallFitOf(const std::vector<Vector3d>& nodes, const Lattice& wall, std::size_t triangles) {
    const auto layers = static_cast<std::size_t>(wall.filling.layers);
    const std::size_t places = nodes.size() / (layers + 1), prisms = wall.tetrahedra.size() / (3 * layers);
    WallFit fit{places, 0, std::numeric_limits<double>::infinity(), triangles - std::min(triangles, prisms)};
    for (std::size_t i = 0; i < places; ++i) {
        const double thickness = (nodes[i] - nodes[nodes.size() - places + i]).norm();
        fit.least = std::min(fit.least, thickness);
        if (thickness < 0.99 * wall.filling.wallThickness) ++fit.thinner;
    }
    return fit;
}

bool isOftenThinner(const WallFit& fit) {
    return 10 * fit.thinner > fit.places;
}

} // namespace esm

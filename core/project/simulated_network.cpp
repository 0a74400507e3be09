#include "core/project/simulated_network.h"

#include "core/model/motion_model.h"
#include "core/model/net_elasticity.h"
#include "core/solid/lattice_binding.h"
#include "core/solid/prism_wall.h"
#include "core/support/errors.h"
#include "core/surface/simplify.h"

namespace esm {

namespace {

// The nodes are vertices of the drawn mesh, with springs along the edges of the coarser one, and those as
// long as its edges are. A surface that could not be made coarser at all needs no binding: each vertex is its
// node.
SpringNetwork coarserNetwork(const TriangleMesh& mesh, std::size_t nodes, const Progress& progress) {
    ProgressParts parts(progress);
    const SimplifiedMesh simulated = simplify(mesh, nodes, parts.next(0.4));
    if (simulated.vertices.size() == mesh.vertices.size()) return networkFromMesh(mesh);
    TriangleMesh coarse{{}, simulated.triangles};
    for (const std::uint32_t vertex : simulated.vertices)
        coarse.vertices.push_back(mesh.vertices[vertex]);
    SpringNetwork network = networkFromMesh(coarse);
    network.binding = bindToSurface(mesh, simulated, parts.rest());
    network.vertexNodes = mainNodes(*network.binding);
    return network;
}

/// Springs at rest where the nodes are, and their shares.
void addLatticeSprings(SpringNetwork& network, Lattice& lattice, const std::vector<LatticeSpring>& springs) {
    for (const auto& [first, second, constant] : springs) {
        network.springs.push_back(
            {first, second, (network.restPositions[first] - network.restPositions[second]).norm()});
        lattice.springShares.push_back(constant);
    }
}

/// The outer nodes of the wall are the vertices, and each carries its own.
SpringNetwork walledNetwork(const TriangleMesh& mesh, const LatticeFilling& filling,
                            const Progress& progress) {
    PrismWall wall = prismWall(mesh, filling, progress);
    SpringNetwork network;
    Binding binding;
    const double whole = 1;
    for (const std::uint32_t& node : wall.vertexNodes)
        binding.vertices.add({{&node, 1}, {&whole, 1}});
    network.binding = std::move(binding);
    network.vertexNodes = std::move(wall.vertexNodes);
    network.restPositions = std::move(wall.nodes);
    Lattice lattice{filling, {}, outerTriangles(wall.tetrahedra), {}};
    addLatticeSprings(network, lattice, wall.springs);
    lattice.tetrahedra = std::move(wall.tetrahedra);
    network.lattice = std::move(lattice);
    return network;
}

SpringNetwork filledNetwork(const TriangleMesh& mesh, const LatticeFilling& filling,
                            const Progress& progress) {
    if (isWall(filling)) return walledNetwork(mesh, filling, progress);
    ProgressParts parts(progress);
    FilledBody filled = fillBody(mesh, filling, parts.next(0.8));
    SpringNetwork network;
    network.binding = bindToLattice(mesh, filled, parts.rest());
    network.vertexNodes = mainNodes(*network.binding);
    Lattice lattice{filling, {}, outerTriangles(filled.tetrahedra), {}};
    network.restPositions = std::move(filled.nodes);
    addLatticeSprings(network, lattice, filled.springs);
    lattice.tetrahedra = std::move(filled.tetrahedra);
    network.lattice = std::move(lattice);
    return network;
}

SpringNetwork networkOfKind(const TriangleMesh& mesh, const Detail& detail, const Progress& progress) {
    switch (detail.kind) {
    case Detail::Kind::Nodes:
        return coarserNetwork(mesh, detail.nodes, progress);
    case Detail::Kind::Rigid:
        return motionModelOf(mesh);
    case Detail::Kind::Filled:
        return filledNetwork(mesh, detail.filling.value_or(LatticeFilling()), progress);
    case Detail::Kind::EveryVertex:
        break;
    }
    return networkFromMesh(mesh);
}

} // namespace

SpringNetwork networkOf(const TriangleMesh& mesh, const Detail& detail, const Progress& progress) {
    const bool isSurface = detail.kind == Detail::Kind::EveryVertex || detail.kind == Detail::Kind::Nodes;
    if (!detail.isEven || !isSurface) return networkOfKind(mesh, detail, progress);
    ProgressParts parts(progress);
    SpringNetwork network = networkOfKind(mesh, detail, parts.next(0.6));
    network.sheet = evenSheetOf(mesh, network, parts.rest());
    return network;
}

std::optional<SheetShares> evenSheetOf(const TriangleMesh& mesh, const SpringNetwork& network,
                                       const Progress& progress) {
    const std::vector<Triangle> surface = simulatedSurface(mesh, network);
    const bool isRigid = detailOf(network).kind == Detail::Kind::Rigid;
    if (network.lattice || isRigid || surface.empty()) return std::nullopt;
    return sheetShares(network.restPositions, network.springs, surface, progress);
}

} // namespace esm

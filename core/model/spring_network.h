#pragma once

#include "core/model/binding.h"
#include "core/model/lattice.h"
#include "core/model/sheet_shares.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace esm {

struct Spring {
    std::uint32_t first, second; ///< node indices
    double restLength;           ///< m
};

/// The nodes and springs under an organ's surface. Immutable once built, like the mesh.
struct SpringNetwork {
    std::vector<Eigen::Vector3d> restPositions; ///< m, one per node
    std::vector<Spring> springs;
    std::vector<std::uint32_t> vertexNodes; ///< the node that carries most of each vertex of the drawn mesh
    std::optional<Binding> binding;         ///< none: each drawn vertex keeps its place at its node
    std::optional<Lattice> lattice{};       ///< of what fills the body; its nodes carry all by the binding
    std::optional<SheetShares> sheet{};     ///< of a surface whose springs make an even sheet
};

/// Edges become springs, vertices nodes [R 2.3.7]; node i is vertex i.
SpringNetwork networkFromMesh(const TriangleMesh& mesh);

/// Where the nodes carry the vertices of the drawn mesh, m. Precondition: the network is this mesh's.
std::vector<Eigen::Vector3d> drawnPositions(const TriangleMesh& mesh, const SpringNetwork& network,
                                            const std::vector<Eigen::Vector3d>& nodePositions);

/// The box that holds the drawn mesh at rest; where nothing is drawn, the nodes.
Eigen::AlignedBox3d organBox(const TriangleMesh& mesh, const SpringNetwork& network);

/// The triangles over the nodes that an instrument touches. Empty for what only its nodes show or carry.
std::vector<Triangle> simulatedSurface(const TriangleMesh& mesh, const SpringNetwork& network);

/// Every problem in how a network carries a drawn mesh.
std::vector<std::string> carryingProblems(const TriangleMesh& mesh, const SpringNetwork& network);

} // namespace esm

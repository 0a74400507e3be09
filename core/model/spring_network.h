#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstdint>
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
    std::vector<std::uint32_t> vertexNodes; ///< the node that carries each vertex of the drawn mesh
};

/// Edges become springs, vertices nodes [R 2.3.7]; node i is vertex i.
SpringNetwork networkFromMesh(const TriangleMesh& mesh);

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"

namespace esm {

/// A coarser surface through some of the vertices of another.
struct SimplifiedMesh {
    std::vector<std::uint32_t> vertices; ///< those of the finer surface that are kept, ascending
    std::vector<Triangle> triangles;     ///< places in `vertices`
};

constexpr std::size_t fewestVertices = 4;

/// Leaves out vertices until `vertexCount` remain, first where the surface changes least (quadric error
/// metrics, meshoptimizer), but nowhere far more than elsewhere. Borders count more than what lies within;
/// every connected part keeps a triangle. Vertices at edges of more than two triangles stay, so that more
/// than asked for may remain. The same surface gives the same result.
/// @throws InvalidModel when fewer than 4 vertices or more than there are are asked for
SimplifiedMesh simplify(const TriangleMesh& mesh, std::size_t vertexCount);

} // namespace esm

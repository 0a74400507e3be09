#pragma once

#include "core/geometry/triangle_mesh.h"

namespace esm {

/// A coarser surface through some of the vertices of another.
struct SimplifiedMesh {
    std::vector<std::uint32_t> vertices; ///< those of the finer surface that are kept, ascending
    std::vector<Triangle> triangles;     ///< places in `vertices`
};

inline constexpr std::size_t fewestVertices = 4; ///< that one keeps

} // namespace esm

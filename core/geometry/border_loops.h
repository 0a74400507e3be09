#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <vector>

namespace esm {

/// Vertices along an open border that comes back to where it began, each once, in the direction in which the
/// triangles run along it: from each to the next, and from the last to the first.
using BorderLoop = std::vector<std::uint32_t>;

/// Where a surface ends: its edges of one triangle.
struct Borders {
    std::vector<BorderLoop> loops;
    std::size_t looseEdges = 0; ///< of no loop: their way ends where surfaces branch or turn inside out

    std::size_t edgeCount() const;
};

/// A border that touches itself in a vertex counts as a loop on each side of it. Loops are in the order of
/// their lowest edges.
Borders bordersOf(const std::vector<Triangle>& triangles);

/// Of all its edges, unit of the vertices.
double lengthOf(const BorderLoop& loop, const std::vector<Eigen::Vector3d>& vertices);

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>

namespace esm {

/// One side of a triangle.
struct TriangleSide {
    Edge edge;
    std::uint32_t triangle;
    bool forward; ///< the triangle runs along it from the smaller to the larger vertex index
};

/// Every side of every triangle, sorted by edge, then by triangle: the sides of one edge lie together.
std::vector<TriangleSide> sidesByEdge(const std::vector<Triangle>& triangles);

/// Calls `visit(first, last)` for every edge with the range of its sides.
template<typename Visit> void forEachEdge(const std::vector<TriangleSide>& sides, Visit visit) {
    for (auto first = sides.begin(); first != sides.end();) {
        auto last = first + 1;
        while (last != sides.end() && last->edge == first->edge)
            ++last;
        visit(first, last);
        first = last;
    }
}

/// Across each side of each triangle, from a corner to the next, the one that lies there; `noIndex` where the
/// surface ends, branches or turns its inside out.
std::vector<Triangle> trianglesAcross(const std::vector<Triangle>& triangles);

struct EdgeCounts {
    std::size_t boundary = 0;     ///< of one triangle
    std::size_t nonManifold = 0;  ///< of more than two
    std::size_t inconsistent = 0; ///< of two triangles that run along it in the same direction

    /// Whether the triangles enclose a volume: no border, and an inside and an outside everywhere.
    bool isClosed() const { return boundary + inconsistent == 0; }
};

EdgeCounts countEdges(const std::vector<TriangleSide>& sides);

struct Parts {
    std::vector<std::uint32_t> ofTriangle; ///< each triangle's part, numbered by first triangle
    std::size_t count = 0;
};

/// Connected parts: triangles that share a vertex belong together.
Parts connectedParts(const std::vector<Triangle>& triangles, std::size_t vertexCount);

} // namespace esm

#include "core/geometry/adjacency.h"

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/sorted_by_vertex.h"

#include <algorithm>

namespace esm {

// Triangles are neighbours where they share an edge. Written down once for each of its triangles and put into
// order, the sides of an edge lie side by side: all that asks for neighbours walks along one list. A hash
// table of edges finds them as well, but its entries are scattered in memory; counting is faster than hashing
// or sorting all of them was (docs/performance.md).
std::vector<TriangleSide> sidesByEdge(const std::vector<Triangle>& triangles) {
    std::vector<TriangleSide> sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangles[i][corner], to = triangles[i][(corner + 1) % 3];
            sides.push_back({std::minmax({from, to}), static_cast<std::uint32_t>(i), from < to});
        }
    // Counted into the places of their lower vertices, where few are left to sort: time linear in the
    // triangles.
    const auto isLess = [](const TriangleSide& a, const TriangleSide& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
    };
    return sortedByVertex(
        sides, [](const TriangleSide& side) { return side.edge.first; }, isLess);
}

// A side has a neighbour only where two triangles meet that run along their edge in opposite directions.
// Where more meet, or two in the same direction, there is no saying which one the surface goes on with.
std::vector<Triangle> trianglesAcross(const std::vector<Triangle>& triangles) {
    std::vector<Triangle> across(triangles.size(), {noIndex, noIndex, noIndex});
    const auto sideOf = [&](const TriangleSide& side) -> std::uint32_t& {
        const Triangle& corners = triangles[side.triangle];
        const std::uint32_t start = side.forward ? side.edge.first : side.edge.second;
        const auto corner = std::find(corners.begin(), corners.end(), start) - corners.begin();
        return across[side.triangle][static_cast<std::size_t>(corner)];
    };
    forEachEdge(sidesByEdge(triangles), [&](auto first, auto last) {
        if (last - first != 2 || first->forward == (first + 1)->forward) return;
        sideOf(*first) = (first + 1)->triangle;
        sideOf(*(first + 1)) = first->triangle;
    });
    return across;
}

// The surface encloses a volume where each of its edges has two triangles that run along it in opposite
// directions. What departs from that is counted, and not mended: a border may be meant, and where three
// sheets meet nobody knows which two belong together.
EdgeCounts countEdges(const std::vector<TriangleSide>& sides) {
    EdgeCounts counts;
    forEachEdge(sides, [&counts](auto first, auto last) {
        const auto triangles = last - first;
        counts.boundary += triangles == 1;
        counts.nonManifold += triangles > 2;
        counts.inconsistent += triangles == 2 && first->forward == (first + 1)->forward;
    });
    return counts;
}

// Disjoint sets of vertices: time next to linear in the triangles, and no lists of neighbours. A vertex that
// two triangles share is enough to hold them together, as it is a node to which the springs of both are tied.
Parts connectedParts(const std::vector<Triangle>& triangles, std::size_t vertexCount) {
    DisjointSets sets(vertexCount);
    for (const Triangle& triangle : triangles) {
        sets.join(triangle[0], triangle[1]);
        sets.join(triangle[0], triangle[2]);
    }
    std::vector<std::uint32_t> partOfSet(vertexCount, noIndex);
    Parts parts;
    parts.ofTriangle.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        std::uint32_t& part = partOfSet[sets.lowest(triangle[0])];
        if (part == noIndex) part = static_cast<std::uint32_t>(parts.count++);
        parts.ofTriangle.push_back(part);
    }
    return parts;
}

} // namespace esm

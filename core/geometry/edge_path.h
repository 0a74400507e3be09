#pragma once

#include "core/geometry/adjacency.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace esm {

/// Edges one after the other: vertex numbers, each edge from where the path comes to where it goes.
using EdgePath = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// The vertices along a chain or a loop of edges, each once.
struct VertexPath {
    std::vector<std::uint32_t> vertices;
    std::map<std::uint32_t, std::size_t> places; ///< by vertex
    bool isLoop = false;

    std::optional<std::uint32_t> before(std::size_t place) const;
    std::optional<std::uint32_t> after(std::size_t place) const;
    /// Whether the path goes from one to the other or back.
    bool runsAlong(std::uint32_t first, std::uint32_t second) const;
};

/// @param vertexCount those that there are
/// @throws InvalidModel where the edges are none, not in order, name a vertex that is not there or come to
/// one twice
VertexPath verticesAlong(const EdgePath& path, std::size_t vertexCount);

/// Triangles by their sides. They outlive it.
class TriangleSides {
public:
    explicit TriangleSides(const std::vector<Triangle>& triangles)
        : m_triangles(triangles), m_sides(sidesByEdge(triangles)) {}

    bool hasEdge(std::uint32_t first, std::uint32_t second) const;
    /// @throws InvalidModel where there is no edge, or one of the border
    void requireInner(std::uint32_t first, std::uint32_t second) const;
    /// The triangle that runs from one vertex to the other, which is on the left of that way seen from
    /// outside; none at the border. @throws InvalidModel where more than two triangles meet or two disagree
    std::optional<std::uint32_t> leftOf(std::uint32_t from, std::uint32_t to) const;
    /// The corner of a triangle beside these two.
    std::uint32_t third(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const;

private:
    using Side = std::vector<TriangleSide>::const_iterator;
    std::pair<Side, Side> sidesOf(std::uint32_t first, std::uint32_t second) const;

    const std::vector<Triangle>& m_triangles;
    std::vector<TriangleSide> m_sides;
};

/// What lies around a vertex of a path on its right.
struct RightSide {
    std::vector<std::uint32_t> triangles;
    std::set<std::uint32_t> neighbours; ///< vertices, without those of the path beside it
};

/// None of an end that lies within the surface: it has no right side.
/// @throws InvalidModel where the path touches the border on its way, or the surface itself, and as leftOf()
std::optional<RightSide> rightSideOf(const TriangleSides& sides, const VertexPath& path, std::size_t place);

} // namespace esm

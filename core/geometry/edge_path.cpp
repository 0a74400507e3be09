#include "core/geometry/edge_path.h"

#include "core/support/errors.h"

#include <algorithm>
#include <string>

namespace esm {

namespace {

std::string nodeName(std::uint32_t node) {
    return "node " + std::to_string(node);
}

std::string edgeName(std::uint32_t first, std::uint32_t second) {
    return std::to_string(first) + "-" + std::to_string(second);
}

/// What was met on the way round a vertex.
struct WayRound {
    RightSide met;
    bool endsAtBorder = false;
};

enum class Turn { Clockwise, Counterclockwise }; ///< seen from outside

/// Goes round a vertex from one neighbour until another, or until the border: from triangle to triangle, each
/// across the side that the last one was left by. As many steps as the vertex has triangles. A way that comes
/// back to where it began without meeting its end has gone round one of two fans that touch in the vertex
/// alone.
WayRound goRound(const TriangleSides& sides, std::uint32_t vertex, const Edge& fromTo, Turn turn) {
    WayRound way;
    for (std::uint32_t at = fromTo.first;;) {
        const auto triangle = turn == Turn::Clockwise ? sides.leftOf(at, vertex) : sides.leftOf(vertex, at);
        way.endsAtBorder = !triangle;
        if (!triangle) return way;
        way.met.triangles.push_back(*triangle);
        at = sides.third(*triangle, vertex, at);
        if (at == fromTo.second) return way;
        if (at == fromTo.first)
            throw InvalidModel("the surface touches itself at " + nodeName(vertex) +
                               ", so that the path has no two sides there");
        way.met.neighbours.insert(at);
    }
}

} // namespace

std::optional<std::uint32_t> VertexPath::before(std::size_t place) const {
    if (place > 0) return vertices[place - 1];
    return isLoop ? std::optional(vertices.back()) : std::nullopt;
}

std::optional<std::uint32_t> VertexPath::after(std::size_t place) const {
    if (place + 1 < vertices.size()) return vertices[place + 1];
    return isLoop ? std::optional(vertices.front()) : std::nullopt;
}

bool VertexPath::runsAlong(std::uint32_t first, std::uint32_t second) const {
    const auto place = places.find(first);
    return place != places.end() && (before(place->second) == second || after(place->second) == second);
}

// Edges are named as pairs and not as a row of vertices, so that a list with a gap is found and not bridged.
// A path that comes to a vertex twice would have more than two sides there.
VertexPath verticesAlong(const EdgePath& path, std::size_t vertexCount) {
    if (path.empty()) throw InvalidModel("no edge is named");
    VertexPath along{{path.front().first}, {{path.front().first, 0}}};
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto [first, second] = path[i];
        for (const std::uint32_t node : {first, second})
            if (node >= vertexCount)
                throw InvalidModel("there is no " + nodeName(node) + " then; the last is " +
                                   std::to_string(vertexCount - 1));
        if (first != along.vertices.back())
            throw InvalidModel("edge " + std::to_string(i) + " begins at " + nodeName(first) +
                               ", not where the edge before it ends, at " + nodeName(along.vertices.back()) +
                               "; name the edges in order, each from where the path comes to where it goes");
        along.isLoop = i + 1 == path.size() && i > 1 && second == path.front().first;
        if (along.isLoop) break;
        if (!along.places.emplace(second, along.vertices.size()).second)
            throw InvalidModel("the path comes to " + nodeName(second) +
                               " twice; give each branch as a split of its own");
        along.vertices.push_back(second);
    }
    return along;
}

// Found by halving in the sorted list: a path has few edges beside those of the surface.
std::pair<TriangleSides::Side, TriangleSides::Side> TriangleSides::sidesOf(std::uint32_t first,
                                                                           std::uint32_t second) const {
    const Edge edge = std::minmax(first, second);
    const auto isBefore = [](const TriangleSide& side, const Edge& other) { return side.edge < other; };
    const auto begin = std::lower_bound(m_sides.begin(), m_sides.end(), edge, isBefore);
    const auto end =
        std::find_if(begin, m_sides.end(), [&](const TriangleSide& side) { return side.edge != edge; });
    return {begin, end};
}

bool TriangleSides::hasEdge(std::uint32_t first, std::uint32_t second) const {
    const auto [begin, end] = sidesOf(first, second);
    return begin != end;
}

void TriangleSides::requireInner(std::uint32_t first, std::uint32_t second) const {
    const auto [begin, end] = sidesOf(first, second);
    if (begin == end) throw InvalidModel(edgeName(first, second) + " is no edge of the surface");
    if (end - begin == 1)
        throw InvalidModel("the edge " + edgeName(first, second) +
                           " lies on the border, where nothing is to part");
}

// A triangle runs along its sides counter-clockwise as seen from outside. The one that runs along an edge in
// the path's direction therefore lies on its left.
std::optional<std::uint32_t> TriangleSides::leftOf(std::uint32_t from, std::uint32_t to) const {
    const auto [begin, end] = sidesOf(from, to);
    if (end - begin > 2)
        throw InvalidModel("more than two triangles meet at the edge " + edgeName(from, to) +
                           ", so that it has no two sides");
    if (end - begin == 2 && begin->forward == (begin + 1)->forward)
        throw InvalidModel("the triangles at the edge " + edgeName(from, to) +
                           " do not agree which side is outside");
    const auto left =
        std::find_if(begin, end, [&](const TriangleSide& side) { return side.forward == (from < to); });
    return left == end ? std::nullopt : std::optional(left->triangle);
}

std::uint32_t TriangleSides::third(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const {
    const Triangle& corners = m_triangles[triangle];
    return *std::find_if(corners.begin(), corners.end(),
                         [&](std::uint32_t corner) { return corner != a && corner != b; });
}

// Where two triangles meet at an edge, one runs along it in the path's direction and lies on its left, the
// other runs against it and lies on its right: sides need no normals, and hold on the thinnest tissue. An end
// within the surface is known by the way round it, which comes back to the edge that it began with.
std::optional<RightSide> rightSideOf(const TriangleSides& sides, const VertexPath& path, std::size_t place) {
    const std::uint32_t vertex = path.vertices[place];
    const std::optional<std::uint32_t> before = path.before(place), after = path.after(place);
    if (!before || !after) {
        const std::uint32_t only = after ? *after : *before;
        WayRound way = goRound(sides, vertex, {only, only}, after ? Turn::Clockwise : Turn::Counterclockwise);
        return way.endsAtBorder ? std::optional(std::move(way.met)) : std::nullopt;
    }
    WayRound right = goRound(sides, vertex, {*after, *before}, Turn::Clockwise);
    if (right.endsAtBorder || goRound(sides, vertex, {*after, *before}, Turn::Counterclockwise).endsAtBorder)
        throw InvalidModel("the path touches the border at " + nodeName(vertex) +
                           ", between its ends; give it as two splits");
    return std::move(right.met);
}

} // namespace esm

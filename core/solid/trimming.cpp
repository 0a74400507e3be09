#include "core/solid/trimming.h"

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/sorted_by_vertex.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/unit_cell.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double steep = 0.5;   ///< cosine between a spring and the normal of a wall that it crosses
constexpr double facing = -0.7; ///< cosine between the normals of two walls of a gap

/// Every edge of the tetrahedra once, the smaller node first, in order.
std::vector<Edge> edgesOf(const std::vector<Tetrahedron>& tetrahedra) {
    std::vector<Edge> edges;
    edges.reserve(6 * tetrahedra.size());
    for (const Tetrahedron& nodes : tetrahedra)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                edges.push_back(std::minmax(nodes[i], nodes[j]));
    const auto isLess = [](const Edge& one, const Edge& other) { return one.second < other.second; };
    edges = sortedByVertex(
        edges, [](const Edge& edge) { return edge.first; }, isLess);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// The edges that leave the body, in order.
std::vector<Edge> leavingEdges(const StuffedLattice& lattice, const std::vector<char>& isSuspect,
                               const BodyQuery& query, double deepest, const Progress& progress) {
    const std::vector<Edge> edges = edgesOf(lattice.tetrahedra);
    std::vector<char> leaves(edges.size());
    forEachNode(edges.size(), progress, [&](std::size_t i) {
        auto [first, second] = edges[i];
        if (!isSuspect[first] && !isSuspect[second]) return;
        if (lattice.isOnSurface[first]) std::swap(first, second);
        const BodySegment segment{lattice.nodes[first], lattice.nodes[second], !lattice.isOnSurface[first]};
        leaves[i] = leavesBody(query, segment, deepest) ? 1 : 0;
    });
    std::vector<Edge> leaving;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (leaves[i]) leaving.push_back(edges[i]);
    return leaving;
}

/// Keeps those tetrahedra for which `isKept(i)` holds.
template<typename IsKept> void keepTetrahedra(StuffedLattice& lattice, const IsKept& isKept) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < lattice.tetrahedra.size(); ++i) {
        if (!isKept(i)) continue;
        lattice.tetrahedra[count] = lattice.tetrahedra[i];
        lattice.origins[count] = lattice.origins[i];
        lattice.isWhole[count++] = lattice.isWhole[i];
    }
    lattice.tetrahedra.resize(count);
    lattice.origins.resize(count);
    lattice.isWhole.resize(count);
}

// A spring that would leave goes with all tetrahedra that have it for an edge: left without one of its edges
// a tetrahedron could fold. What they held of the body is lost, a strip about as wide as the spacing along a
// gap that is narrower than that.
void dropLeaving(StuffedLattice& lattice, const std::vector<Edge>& leaving) {
    if (leaving.empty()) return;
    keepTetrahedra(lattice, [&](std::size_t i) {
        const Tetrahedron& nodes = lattice.tetrahedra[i];
        for (std::size_t one = 0; one < 4; ++one)
            for (std::size_t other = one + 1; other < 4; ++other)
                if (std::binary_search(leaving.begin(), leaving.end(),
                                       Edge(std::minmax(nodes[one], nodes[other]))))
                    return false;
        return true;
    });
}

/// Pieces of tetrahedra that meet face to face, each by its first tetrahedron's number.
DisjointSets piecesOf(const std::vector<Tetrahedron>& tetrahedra) {
    struct Face {
        Triangle nodes;
        std::uint32_t tetrahedron;
    };
    std::vector<Face> faces;
    faces.reserve(4 * tetrahedra.size());
    for (std::uint32_t i = 0; i < tetrahedra.size(); ++i) {
        Tetrahedron sorted = tetrahedra[i];
        std::sort(sorted.begin(), sorted.end());
        const auto& [a, b, c, d] = sorted;
        for (const Triangle& nodes :
             {Triangle{a, b, c}, Triangle{a, b, d}, Triangle{a, c, d}, Triangle{b, c, d}})
            faces.push_back({nodes, i});
    }
    faces = sortedByVertex(
        faces, [](const Face& face) { return face.nodes[0]; },
        [](const Face& one, const Face& other) { return one.nodes < other.nodes; });
    DisjointSets pieces(tetrahedra.size());
    for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i].nodes == faces[i - 1].nodes) pieces.join(faces[i].tetrahedron, faces[i - 1].tetrahedron);
    return pieces;
}

// All else is crumbs at sharp rims of a coarse lattice: on eight organs at three spacings less than 0.5 % of
// the volume, and mostly nothing.
void keepLargestPiece(StuffedLattice& lattice) {
    DisjointSets pieces = piecesOf(lattice.tetrahedra);
    std::vector<double> volumes(lattice.tetrahedra.size(), 0.0);
    for (std::uint32_t i = 0; i < lattice.tetrahedra.size(); ++i)
        volumes[pieces.lowest(i)] += volumeOf(lattice.tetrahedra[i], lattice.nodes);
    const auto largest =
        static_cast<std::uint32_t>(std::max_element(volumes.begin(), volumes.end()) - volumes.begin());
    keepTetrahedra(lattice,
                   [&](std::size_t i) { return pieces.lowest(static_cast<std::uint32_t>(i)) == largest; });
}

// Nodes keep their order, so that a lattice from which nothing went is the same as before.
void dropLooseNodes(StuffedLattice& lattice) {
    std::vector<std::uint32_t> numbers(lattice.nodes.size(), noIndex);
    for (const Tetrahedron& nodes : lattice.tetrahedra)
        for (const std::uint32_t node : nodes)
            numbers[node] = 0;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] == noIndex) continue;
        lattice.nodes[count] = lattice.nodes[i];
        lattice.isOnSurface[count] = lattice.isOnSurface[i];
        lattice.points[count] = lattice.points[i];
        numbers[i] = count++;
    }
    lattice.nodes.resize(count);
    lattice.isOnSurface.resize(count);
    lattice.points.resize(count);
    for (Tetrahedron& nodes : lattice.tetrahedra)
        for (std::uint32_t& node : nodes)
            node = numbers[node];
}

} // namespace

// A chord lies as deep outside as its length squared over the bend's radius. A quarter of the spacing for all
// kinds took more of a bent body from those with long springs: of ventricles, at 40 000 nodes, 0.5 % of the
// volume of a cubic lattice and 1.4 % of a diamond one, and 0.3 % of a body-centred one.
double deepestChord(LatticeKind kind, double spacing) {
    // Bare diamond has diamond's tetrahedra, and at the surface springs along all of their edges.
    const UnitCell& cell = unitCellOf(kind == LatticeKind::BareDiamond ? LatticeKind::Diamond : kind);
    double longest = 0;
    for (const CellSpring& spring : cell.springs)
        longest = std::max(longest, (cell.placeOf(spring.second) - cell.sites[spring.first]).norm());
    const double ofBodyCentred = 2 / std::sqrt(3.0);
    return 0.25 * spacing * longest / ofBodyCentred;
}

// Along the way the surface is crossed out and in by turns. Of each stretch outside it is asked how deep it
// lies, and for the walls where it begins and ends: those of a gap face each other, however narrow it is,
// while over a dent that is smaller than the spacing they do not.
bool leavesBody(const BodyQuery& query, const BodySegment& segment, double deepest) {
    const Vector3d along = segment.to - segment.from, direction = along.normalized();
    const double length = along.norm(), margin = 1e-4 * length; // nodes touch the surface at any angle
    const auto placeAt = [&](double way) -> Vector3d { return segment.from + way * direction; };
    const auto isOutside = [&](double begin, double end, const Vector3d& out, const Vector3d& in) {
        // A surface that runs through itself has such walls around what lies within twice.
        if (out.dot(direction) > steep && in.dot(direction) < -steep && out.dot(in) < facing)
            return !query.contains(placeAt((begin + end) / 2));
        // The distance to the surface changes no faster than the way goes on.
        for (double at = begin; at < end;) {
            const double distance = query.nearest(placeAt(at)).distance;
            if (distance > deepest) return !query.contains(placeAt(at));
            at += std::max(deepest - distance, 0.04 * deepest);
        }
        return false;
    };
    double way = margin, begin = 0; // of the stretch since the last crossing
    std::optional<Vector3d> out;    // the wall where a stretch outside began
    bool isKnownInside = segment.isFromInside;
    for (int crossings = 0; crossings < 16 && way < length - margin; ++crossings) {
        const auto hit = query.firstBetween(placeAt(way), placeAt(length - margin));
        if (!hit) break;
        const Vector3d normal = query.normalOf(*hit);
        const double at = way + hit->distance;
        isKnownInside = normal.dot(direction) < 0;
        if (isKnownInside &&
            isOutside(begin, at, out ? *out : query.normalOf(query.nearest(segment.from)), normal))
            return true;
        out = normal;
        begin = at;
        way = at + 1e-6 * length;
    }
    if (isKnownInside) return false;
    const Vector3d first = out ? *out : query.normalOf(query.nearest(segment.from));
    return isOutside(begin, length, first, query.normalOf(query.nearest(segment.to)));
}

// Tetrahedra that share no face turn about a common edge or node like doors, and a lattice must hold together
// as one body does: what hangs on the largest piece by less than a face goes. Where the spacing resolves the
// organ nothing does.
void trim(StuffedLattice& lattice, const std::vector<char>& isSuspect, const BodyQuery& query, double deepest,
          const Progress& progress) {
    ProgressParts parts(progress);
    dropLeaving(lattice, leavingEdges(lattice, isSuspect, query, deepest, parts.next(0.7)));
    if (!lattice.tetrahedra.empty()) keepLargestPiece(lattice);
    dropLooseNodes(lattice);
    reportProgress(parts.rest(), 1);
}

} // namespace esm

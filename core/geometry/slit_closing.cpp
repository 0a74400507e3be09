#include "core/geometry/slit_closing.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/hole_filling.h"
#include "core/geometry/slit_pairing.h"
#include "core/geometry/sorted_by_vertex.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace esm {

namespace {

/// A closed slit may bring new ones within reach, as where three borders came together.
constexpr int mostPasses = 4;
/// A triangle folds over where it turns by more than this, as a cosine.
constexpr double sharpestTurn = 0.2;
/// Twice the area over the longest side's square, below which a triangle collapses that did not before.
constexpr double collapsed = 1e-3;
/// Corners of what is left open at a blunt end of a slit.
constexpr std::size_t mostLeftCorners = 4;

/// A surface with some of its slits stitched.
struct Stitched {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> origins; ///< of each triangle, the one that it was or was part of
    std::vector<std::uint32_t> merged;  ///< of each former vertex, the one that it is
};

/// Vertices to be inserted on a border edge: their places on it, and which.
using Insertions = std::map<Edge, std::vector<std::pair<double, std::uint32_t>>>;

/// A triangle's normal and how thick it is.
struct Shape {
    Eigen::Vector3d normal; ///< of length 1, or none
    double thickness;       ///< twice the area over the longest side's square
};

Shape shapeOf(const std::vector<Eigen::Vector3d>& vertices, const Triangle& triangle) {
    const Eigen::Vector3d u = vertices[triangle[1]] - vertices[triangle[0]];
    const Eigen::Vector3d v = vertices[triangle[2]] - vertices[triangle[0]];
    const Eigen::Vector3d normal = u.cross(v);
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
    return {normal.stableNormalized(), longest > 0 ? normal.norm() / longest : 0};
}

bool folds(const Shape& former, const Shape& shape) {
    return shape.thickness <= std::min(collapsed, former.thickness / 2) ||
           shape.normal.dot(former.normal) < sharpestTurn;
}

/// Edges where surfaces branch or turn inside out, with the number of their sides.
std::set<std::pair<Edge, std::ptrdiff_t>> faultyEdges(const std::vector<Triangle>& triangles) {
    std::set<std::pair<Edge, std::ptrdiff_t>> faulty;
    forEachEdge(sidesByEdge(triangles), [&](auto first, auto last) {
        if (last - first > 2 || (last - first == 2 && first->forward == (first + 1)->forward))
            faulty.emplace(first->edge, last - first);
    });
    return faulty;
}

// Stretches are stitched all at once and the outcome is looked at: a triangle that folded over, an edge with
// more than two triangles. Each stretch that has to do with one is left out, and all others are stitched
// again, until nothing is wrong. Looking at the outcome needs no rule for every way in which borders may lie,
// and takes few rounds, as leaving out makes nothing worse.
class Stitcher {
public:
    Stitcher(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Triangle>& triangles,
             double width)
        : m_vertices(vertices), m_triangles(triangles), m_corners(bordersOf(triangles).loops),
          m_stretches(slitStretches(vertices, m_corners, width)) {}

    std::optional<Stitched> stitch(const Progress& progress) {
        ProgressParts attempts(progress);
        while (!m_stretches.empty()) {
            reportProgress(attempts.nextOfRest(0.3), 0);
            Stitched stitched = stitchAll();
            const std::set<std::uint32_t> faulty = faultyVertices(stitched);
            if (faulty.empty()) return stitched;
            if (!leaveOut(faulty, stitched.merged)) return std::nullopt;
        }
        return std::nullopt;
    }

private:
    std::uint32_t vertexAt(const BorderPlace& place) const { return m_corners.vertex[place.corner]; }

    Stitched stitchAll() {
        Stitched stitched{m_vertices, {}, {}, std::vector<std::uint32_t>(m_vertices.size())};
        for (std::uint32_t i = 0; i < m_vertices.size(); ++i)
            stitched.merged[i] = i;
        Insertions insertions;
        for (const SlitStretch& stretch : m_stretches)
            for (const PlacePair& pair : stretch)
                join(pair, stitched, insertions);
        for (auto& [edge, inserted] : insertions)
            std::sort(inserted.begin(), inserted.end());
        for (std::uint32_t i = 0; i < m_triangles.size(); ++i)
            divide(m_triangles[i], i, insertions, stitched);
        return stitched;
    }

    void join(const PlacePair& pair, Stitched& stitched, Insertions& insertions) const {
        const Eigen::Vector3d middle =
            (positionOf(pair.one, m_corners, m_vertices) + positionOf(pair.other, m_corners, m_vertices)) / 2;
        for (const auto& [place, across] :
             {std::pair(pair.one, pair.other), std::pair(pair.other, pair.one)}) {
            if (place.isCorner()) {
                stitched.vertices[vertexAt(place)] = middle;
                continue;
            }
            const Edge edge{vertexAt(place), m_corners.vertex[m_corners.next[place.corner]]};
            const std::pair<double, std::uint32_t> inserted{place.along, vertexAt(across)};
            auto& all = insertions[edge];
            // A pair is at the end of two stretches.
            if (std::find(all.begin(), all.end(), inserted) == all.end()) all.push_back(inserted);
        }
        if (!pair.one.isCorner() || !pair.other.isCorner()) return;
        const auto [low, high] = std::minmax({vertexAt(pair.one), vertexAt(pair.other)});
        stitched.merged[high] = low;
    }

    /// Triangles from the corner across a divided edge to each of its parts.
    void divide(const Triangle& triangle, std::uint32_t origin, const Insertions& insertions,
                Stitched& stitched) const {
        for (std::size_t side = 0; side < 3 && !insertions.empty(); ++side) {
            const std::uint32_t from = triangle[side], to = triangle[(side + 1) % 3];
            const std::uint32_t across = triangle[(side + 2) % 3];
            const auto found = insertions.find({from, to});
            if (found == insertions.end()) continue;
            std::uint32_t last = from;
            for (const auto& [along, vertex] : found->second) {
                divide({last, vertex, across}, origin, insertions, stitched);
                last = vertex;
            }
            return divide({last, to, across}, origin, insertions, stitched);
        }
        const auto& merged = stitched.merged;
        stitched.triangles.push_back({merged[triangle[0]], merged[triangle[1]], merged[triangle[2]]});
        stitched.origins.push_back(origin);
    }

    std::set<std::uint32_t> faultyVertices(const Stitched& stitched) {
        std::set<std::uint32_t> faulty;
        std::vector<Triangle> changed;
        for (std::size_t i = 0; i < stitched.triangles.size(); ++i) {
            const Triangle& triangle = stitched.triangles[i];
            const Triangle& former = m_triangles[stitched.origins[i]];
            const auto isMoved = [&](std::size_t corner) {
                return triangle[corner] != former[corner] ||
                       stitched.vertices[triangle[corner]] != m_vertices[former[corner]];
            };
            if (!isMoved(0) && !isMoved(1) && !isMoved(2)) continue;
            if (folds(shapeOf(m_vertices, former), shapeOf(stitched.vertices, triangle)))
                faulty.insert(triangle.begin(), triangle.end());
            changed.push_back(triangle);
            std::sort(changed.back().begin(), changed.back().end());
        }
        const std::vector<bool> isRepeated = repeats(changed);
        for (std::size_t i = 0; i < changed.size(); ++i)
            if (isRepeated[i]) faulty.insert(changed[i].begin(), changed[i].end());
        addFaultyEdges(stitched, faulty);
        return faulty;
    }

    void addFaultyEdges(const Stitched& stitched, std::set<std::uint32_t>& faulty) {
        std::set<std::pair<Edge, std::ptrdiff_t>> known;
        for (const auto& [edge, sides] : faultyEdges(m_triangles))
            known.emplace(std::minmax(stitched.merged[edge.first], stitched.merged[edge.second]), sides);
        for (const auto& [edge, sides] : faultyEdges(stitched.triangles))
            if (known.count({edge, sides}) == 0) faulty.insert({edge.first, edge.second});
    }

    bool leaveOut(const std::set<std::uint32_t>& faulty, const std::vector<std::uint32_t>& merged) {
        const auto isFaulty = [&](const BorderPlace& place) {
            return place.isCorner() && faulty.count(merged[vertexAt(place)]) > 0;
        };
        return std::erase_if(m_stretches, [&](const SlitStretch& stretch) {
                   return std::any_of(stretch.begin(), stretch.end(), [&](const PlacePair& pair) {
                       return isFaulty(pair.one) || isFaulty(pair.other);
                   });
               }) > 0;
    }

    const std::vector<Eigen::Vector3d>& m_vertices;
    const std::vector<Triangle>& m_triangles;
    BorderCorners m_corners;
    std::vector<SlitStretch> m_stretches;
};

/// At a blunt end of a slit a small hole is left, between the edge across the gap and the first vertex that
/// is joined: it cannot be joined itself, since its two vertices are neighbours.
void fillBluntEnds(const std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles,
                   const std::vector<bool>& isStitched, double width, const Progress& progress) {
    std::vector<BorderLoop> ends;
    for (BorderLoop& loop : bordersOf(triangles).loops) {
        const auto isShort = [&](std::size_t i) {
            return (vertices[loop[i]] - vertices[loop[(i + 1) % loop.size()]]).norm() <= width * (1 + 1e-6);
        };
        bool isBlunt = false, touches = false;
        for (std::size_t i = 0; i < loop.size() && loop.size() <= mostLeftCorners; ++i) {
            isBlunt = isBlunt || isShort(i);
            touches = touches || isStitched[loop[i]];
        }
        if (isBlunt && touches) ends.push_back(std::move(loop));
    }
    fillHoles(vertices, triangles, ends, progress);
}

} // namespace

ClosedSlits closeSlits(std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles, double width,
                       const Progress& progress) {
    const std::size_t before = bordersOf(triangles).edgeCount();
    ClosedSlits closed;
    closed.origins.resize(triangles.size());
    std::iota(closed.origins.begin(), closed.origins.end(), 0U);
    const std::vector<Eigen::Vector3d> former = vertices;
    ProgressParts parts(progress);
    for (int pass = 0; pass < mostPasses; ++pass) {
        std::optional<Stitched> stitched =
            Stitcher(vertices, triangles, width).stitch(parts.next(0.8 / mostPasses));
        if (!stitched) break;
        vertices = std::move(stitched->vertices);
        triangles = std::move(stitched->triangles);
        for (std::uint32_t& origin : stitched->origins)
            origin = closed.origins[origin];
        closed.origins = std::move(stitched->origins);
    }
    std::vector<bool> isStitched;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        isStitched.push_back(vertices[i] != former[i]);
    fillBluntEnds(vertices, triangles, isStitched, width, parts.rest());
    closed.origins.resize(triangles.size(), noIndex);
    closed.edges = before - bordersOf(triangles).edgeCount();
    return closed;
}

} // namespace esm

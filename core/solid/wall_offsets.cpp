#include "core/solid/wall_offsets.h"

#include "core/geometry/adjacency.h"
#include "core/geometry/cells_at_points.h"
#include "core/solid/closed_body.h"
#include "core/solid/parallel_nodes.h"
#include "core/solid/self_intersections.h"
#include "core/support/numbers.h"
#include "core/surface/surface_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace esm {

namespace {

using Eigen::Vector3d;

// Greedy, so that neighbours differ. The vertices of the first colour only have diagonals that lead inwards
// from them, those of the last only ones that lead to the node beneath them. Both have them to all sides,
// and so most of a wall is stretched without that its inner side slides against the outer one. Of an order by
// numbers alone all diagonals of a regular mesh would lean the same way.
std::vector<std::uint32_t> diagonalOrder(const TriangleMesh& mesh, const CellsAtPoints& trianglesAt) {
    const std::size_t count = mesh.vertices.size();
    std::vector<std::uint32_t> colours(count, noIndex), sizes;
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
        std::vector<char> isTaken(sizes.size() + 1, 0);
        trianglesAt.forEachAt(vertex, [&](std::uint32_t triangle) {
            for (const std::uint32_t other : mesh.triangles[triangle])
                if (colours[other] != noIndex) isTaken[colours[other]] = 1;
        });
        const auto free = std::find(isTaken.begin(), isTaken.end(), 0) - isTaken.begin();
        colours[vertex] = static_cast<std::uint32_t>(free);
        if (colours[vertex] == sizes.size()) sizes.push_back(0);
        ++sizes[colours[vertex]];
    }
    const auto last = static_cast<std::uint32_t>(sizes.size());
    const auto rankOf = [&](std::uint32_t colour) { return colour == 1 ? last : colour; };
    std::vector<std::uint32_t> vertices(count), order(count);
    std::iota(vertices.begin(), vertices.end(), 0U);
    std::stable_sort(vertices.begin(), vertices.end(), [&](std::uint32_t one, std::uint32_t other) {
        return rankOf(colours[one]) < rankOf(colours[other]);
    });
    for (std::uint32_t place = 0; place < count; ++place)
        order[vertices[place]] = place;
    return order;
}

void refuseBranching(const TriangleMesh& mesh) {
    std::size_t branching = 0, turning = 0;
    Vector3d place = Vector3d::Zero();
    forEachEdge(sidesByEdge(mesh.triangles), [&](auto first, auto last) {
        const bool branches = last - first > 2;
        const bool turns = last - first == 2 && first->forward == (first + 1)->forward;
        if ((branches || turns) && branching + turning == 0)
            place = (mesh.vertices[first->edge.first] + mesh.vertices[first->edge.second]) / 2;
        branching += branches ? 1 : 0;
        turning += turns ? 1 : 0;
    });
    if (branching > 0)
        throw InvalidModel("the surface branches: at " + std::to_string(branching) +
                           " edges more than two triangles meet, the first at " + placeText(place) +
                           "; part it there in a modelling program, or keep the organ hollow, as a surface");
    if (turning > 0)
        throw InvalidModel("the surface turns its inside out at " + std::to_string(turning) +
                           " edges, the first at " + placeText(place) +
                           "; repair it in a modelling program, or keep the organ hollow, as a surface");
}

// Directions are found first and stay; lengths only ever become shorter, so that each loop ends: at the
// latest where every prism that is at fault is as thin as it may be, and is left out. Thickness is first
// bounded by the room to the opposite wall, which a ray tells, then by the shape of each prism, and last by
// what of the inner side meets anything, for which the whole wall is looked at.
/// Finds how far the wall may reach from each vertex.
class WallFitter {
public:
    WallFitter(const TriangleMesh& mesh, const LatticeFilling& filling)
        : m_mesh(mesh), m_filling(filling), m_trianglesAt(mesh.triangles, mesh.vertices.size()),
          m_edges(uniqueEdges(mesh.triangles)), m_lengths(mesh.vertices.size(), filling.wallThickness) {
        m_offsets.order = diagonalOrder(mesh, m_trianglesAt);
        m_offsets.isLeftOut.assign(mesh.triangles.size(), 0);
        for (const Triangle& triangle : mesh.triangles)
            m_normals.push_back(areaNormal(mesh.vertices, triangle).normalized());
    }

    WallOffsets fit(const Progress& progress) {
        ProgressParts parts(progress);
        findDirections(parts.next(0.1));
        leaveOutCrossings();
        keepOffOppositeWall(parts.next(0.2));
        keepPrismsSound();
        keepInnerSideApart(parts.rest());
        restoreAtBareVertices();
        refuseGaps();
        m_offsets.least = *std::min_element(m_lengths.begin(), m_lengths.end());
        m_offsets.shortened =
            static_cast<std::size_t>(std::count_if(m_lengths.begin(), m_lengths.end(), [&](double length) {
                return length < 0.99 * m_filling.wallThickness;
            }));
        return std::move(m_offsets);
    }

private:
    // The mean of the normals around a vertex, turned towards the one that it sees least of: a prism is
    // sound at all only where each triangle sees the way inwards from behind.
    void findDirections(const Progress& progress) {
        m_directions = vertexNormals(m_mesh.vertices, m_mesh.triangles);
        forEachNode(m_directions.size(), progress, [&](std::size_t vertex) {
            const Vector3d mean = m_directions[vertex];
            double least = 0;
            for (int turn = 0; turn < 30 && least <= 0.3; ++turn) {
                least = 1;
                Vector3d worst = m_directions[vertex];
                for (std::size_t i = m_trianglesAt.starts[vertex]; i < m_trianglesAt.starts[vertex + 1];
                     ++i) {
                    const Vector3d& normal = m_normals[m_trianglesAt.numbers[i]];
                    const double seen = normal.dot(m_directions[vertex]);
                    if (seen < least) {
                        least = seen;
                        worst = normal;
                    }
                }
                if (least <= 0.3) m_directions[vertex] = (m_directions[vertex] + 0.3 * worst).normalized();
            }
            if (least <= 0.02) m_directions[vertex] = mean; // the fewest triangles are folded over
        });
        for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i)
            for (const std::uint32_t vertex : m_mesh.triangles[i])
                if (!(m_normals[i].dot(m_directions[vertex]) > 0.02)) leaveOut(i);
    }

    /// m: no place of a wall is thinner.
    double least() const { return 0.01 * m_filling.wallThickness; }

    void leaveOut(std::uint32_t triangle) { m_offsets.isLeftOut[triangle] = 1; }

    /// What of the surface runs through itself has no wall of its own.
    void leaveOutCrossings() {
        for (const auto& [one, other, place] : meetingTriangles(m_mesh))
            for (const std::uint32_t triangle : {one, other})
                leaveOut(triangle);
    }

    std::vector<char> verticesWithPrism() const {
        std::vector<char> hasPrism(m_lengths.size(), 0);
        for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
            for (const std::uint32_t vertex : m_mesh.triangles[i])
                if (m_offsets.isLeftOut[i] == 0) hasPrism[vertex] = 1;
        return hasPrism;
    }

    // The nodes of a vertex whose triangles were all left out would be of no tetrahedron. It gets the first
    // prism that is sound with the triangle's own normal as its direction, even where that crosses another.
    // Its other corners then have one as well, and stay as they are.
    void restoreAtBareVertices() {
        std::vector<char> hasPrism = verticesWithPrism();
        for (std::uint32_t vertex = 0; vertex < hasPrism.size(); ++vertex)
            for (std::size_t i = m_trianglesAt.starts[vertex];
                 hasPrism[vertex] == 0 && i < m_trianglesAt.starts[vertex + 1]; ++i)
                if (restore(m_trianglesAt.numbers[i], vertex))
                    for (const std::uint32_t corner : m_mesh.triangles[m_trianglesAt.numbers[i]])
                        hasPrism[corner] = 1;
    }

    bool restore(std::uint32_t triangle, std::uint32_t vertex) {
        const Vector3d before = m_directions[vertex];
        m_directions[vertex] = m_normals[triangle];
        const auto seesIt = [&](std::uint32_t corner) {
            return m_normals[triangle].dot(m_directions[corner]) > 0.02;
        };
        const Triangle& corners = m_mesh.triangles[triangle];
        m_lengths[vertex] = least();
        updateInwards();
        const bool isSoundNow = std::all_of(corners.begin(), corners.end(), seesIt) &&
                                isSound(triangle, wallNodes(m_mesh.vertices, m_offsets, m_filling.layers));
        if (isSoundNow) m_offsets.isLeftOut[triangle] = 0;
        if (!isSoundNow) m_directions[vertex] = before;
        updateInwards();
        return isSoundNow;
    }

    void refuseGaps() const {
        const auto& isLeftOut = m_offsets.isLeftOut;
        const auto count = static_cast<std::size_t>(std::count(isLeftOut.begin(), isLeftOut.end(), 1));
        const std::vector<char> hasPrism = verticesWithPrism();
        const auto bare = std::find(hasPrism.begin(), hasPrism.end(), 0) - hasPrism.begin();
        const bool isBare = bare < static_cast<std::ptrdiff_t>(hasPrism.size());
        if (50 * count <= isLeftOut.size() && !isBare) return;
        const auto first = std::find(isLeftOut.begin(), isLeftOut.end(), 1) - isLeftOut.begin();
        const std::uint32_t vertex =
            isBare ? static_cast<std::uint32_t>(bare) : m_mesh.triangles[static_cast<std::size_t>(first)][0];
        throw InvalidModel(
            "no wall fits under " + std::to_string(count) + " of " + std::to_string(isLeftOut.size()) +
            " triangles: the surface is folded over, runs through itself or bends too sharply, "
            "as at " +
            placeText(m_mesh.vertices[vertex]) +
            "; smooth it in a modelling program, choose a thinner wall, or keep the organ "
            "hollow, as a surface");
    }

    // Two walls that face each other leave a tenth of the room free.
    void keepOffOppositeWall(const Progress& progress) {
        const SurfaceQuery query(m_mesh.vertices, m_mesh.triangles);
        forEachNode(m_lengths.size(), progress, [&](std::size_t vertex) {
            const Vector3d inwards = -m_directions[vertex];
            const double start = 1e-3 * m_filling.wallThickness;
            const auto hit = query.firstHit({m_mesh.vertices[vertex] + start * inwards, inwards});
            if (hit)
                m_lengths[vertex] = std::clamp(0.45 * (start + hit->distance), least(), m_lengths[vertex]);
        });
        std::vector<double> lengths = m_lengths;
        const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
        std::nth_element(lengths.begin(), middle, lengths.end());
        if (*middle < 0.5 * m_filling.wallThickness)
            throw InvalidModel("a wall of " + millimetresText(m_filling.wallThickness, 4) +
                               " is too thick: half of the organ has room for " +
                               millimetresText(*middle, 2) + " or less; choose a thinner wall");
        even();
    }

    // The inner side goes from one thickness to another within about as much of the surface.
    void even() {
        constexpr double slope = 0.7;
        for (bool isEven = false; !isEven;) {
            isEven = true;
            for (const auto& [one, other] : m_edges) {
                const double most = slope * (m_mesh.vertices[one] - m_mesh.vertices[other]).norm();
                double &a = m_lengths[one], &b = m_lengths[other];
                if (std::abs(a - b) <= 1.001 * most) continue;
                (a > b ? a : b) = std::min(a, b) + most;
                isEven = false;
            }
        }
    }

    void updateInwards() {
        m_offsets.inwards.resize(m_lengths.size());
        for (std::size_t i = 0; i < m_lengths.size(); ++i)
            m_offsets.inwards[i] = -m_lengths[i] * m_directions[i];
    }

    void shortenMarked() {
        for (std::uint32_t vertex = 0; vertex < m_isMarked.size(); ++vertex)
            if (m_isMarked[vertex] != 0) m_lengths[vertex] = std::max(0.75 * m_lengths[vertex], least());
        even();
    }

    bool isAtItsLeast(const Triangle& triangle) const {
        return std::all_of(triangle.begin(), triangle.end(),
                           [&](std::uint32_t vertex) { return m_lengths[vertex] < 2 * least(); });
    }

    /// Marks where a triangle's wall has to be thinner, or leaves the triangle out.
    void thin(std::uint32_t triangle) {
        if (isAtItsLeast(m_mesh.triangles[triangle])) return leaveOut(triangle);
        markLong(m_mesh.triangles[triangle]);
    }

    /// The corners where the wall is thick: where it is far thinner than beside them it is not their fault.
    void markLong(const Triangle& triangle) {
        double longest = 0;
        for (const std::uint32_t vertex : triangle)
            longest = std::max(longest, m_lengths[vertex]);
        for (const std::uint32_t vertex : triangle)
            if (m_lengths[vertex] > 0.5 * longest) m_isMarked[vertex] = 1;
    }

    /// Whether no tetrahedron has less than a tenth of what it would have if the inner side were as large as
    /// the outer one.
    bool isSound(std::uint32_t number, const std::vector<Vector3d>& nodes) const {
        const Triangle& triangle = m_mesh.triangles[number];
        double height = std::numeric_limits<double>::infinity();
        for (const std::uint32_t vertex : triangle)
            height = std::min(height, m_lengths[vertex] * m_normals[number].dot(m_directions[vertex]));
        const double straight =
            areaNormal(m_mesh.vertices, triangle).norm() / 2 * height / m_filling.layers / 3;
        for (int layer = 0; layer < m_filling.layers; ++layer)
            for (const Tetrahedron& tetrahedron :
                 prismOf(triangle, m_offsets.order, static_cast<std::uint32_t>(layer),
                         static_cast<std::uint32_t>(m_lengths.size())))
                if (!(esm::volumeOf(tetrahedron, nodes) > 0.1 * straight)) return false;
        return true;
    }

    // A prism that is at fault gets thinner by a quarter, and with it what lies around, until it is sound:
    // within a radius of curvature it always is, as its inner side is then as large as the outer one.
    void keepPrismsSound() {
        for (bool isDone = false; !isDone;) {
            updateInwards();
            const std::vector<Vector3d> nodes = wallNodes(m_mesh.vertices, m_offsets, m_filling.layers);
            m_isMarked.assign(m_lengths.size(), 0);
            for (std::uint32_t i = 0; i < m_mesh.triangles.size(); ++i)
                if (m_offsets.isLeftOut[i] == 0 && !isSound(i, nodes)) thin(i);
            isDone = std::count(m_isMarked.begin(), m_isMarked.end(), 1) == 0;
            if (!isDone) shortenMarked();
        }
    }

    /// The outer and the inner side of the wall; the rims of open ones cross nothing that these do not.
    TriangleMesh bothSides() const {
        const auto count = static_cast<std::uint32_t>(m_lengths.size());
        TriangleMesh sides{wallNodes(m_mesh.vertices, m_offsets, 1), m_mesh.triangles, {}};
        for (const auto& [a, b, c] : m_mesh.triangles)
            sides.triangles.push_back({a + count, c + count, b + count});
        return sides;
    }

    /// Whether a triangle of both sides has a prism.
    bool isWalled(std::uint32_t triangle) const {
        return m_offsets.isLeftOut[triangle % m_mesh.triangles.size()] == 0;
    }

    // Where two triangles cross of which one is outside, the inner one gives way; of two inner ones both do.
    void keepInnerSideApart(const Progress& progress) {
        for (int round = 0;; ++round) {
            reportProgress(progress, 1 - 1 / (1 + 0.1 * round));
            const TriangleMesh sides = bothSides();
            m_isMarked.assign(m_lengths.size(), 0);
            const std::vector<MeetingTriangles> met = meetingTriangles(sides);
            const bool isApart = std::none_of(met.begin(), met.end(), [&](const MeetingTriangles& pair) {
                return isWalled(pair.one) && isWalled(pair.other);
            });
            if (isApart) break;
            for (const auto& [one, other, place] : met)
                for (const std::uint32_t triangle : {one, other})
                    if (isWalled(one) && isWalled(other) && triangle >= m_mesh.triangles.size())
                        thin(triangle - static_cast<std::uint32_t>(m_mesh.triangles.size()));
            shortenMarked();
            keepPrismsSound();
        }
        reportProgress(progress, 1);
    }

    const TriangleMesh& m_mesh;
    const LatticeFilling& m_filling;
    CellsAtPoints m_trianglesAt;
    std::vector<Edge> m_edges;
    std::vector<Vector3d> m_normals;    ///< per triangle, of unit length
    std::vector<Vector3d> m_directions; ///< per vertex, outwards, of unit length
    std::vector<double> m_lengths;      ///< per vertex, m
    std::vector<char> m_isMarked;       ///< per vertex, whether the wall has to be thinner there
    WallOffsets m_offsets;
};

} // namespace

std::vector<Vector3d> wallNodes(const std::vector<Vector3d>& vertices, const WallOffsets& offsets,
                                int layers) {
    std::vector<Vector3d> nodes;
    nodes.reserve(vertices.size() * static_cast<std::size_t>(layers + 1));
    for (int layer = 0; layer <= layers; ++layer)
        for (std::size_t i = 0; i < vertices.size(); ++i)
            nodes.push_back(vertices[i] + static_cast<double>(layer) / layers * offsets.inwards[i]);
    return nodes;
}

WallOffsets wallOffsets(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress) {
    refuseBranching(mesh);
    return WallFitter(mesh, filling).fit(progress);
}

} // namespace esm

#include "core/texture/atlas/unfolding.h"

#include "core/geometry/adjacency.h"
#include "core/support/angles.h"
#include "core/texture/atlas/planar_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace esm {

namespace {

using Flat = std::array<Eigen::Vector2d, 3>; ///< counter-clockwise

/// A group grows while triangles fill so much of its convex hull, and to so many triangles: larger and more
/// ragged ones have fewer seams, but leave more of a page empty. The second triangle may leave half of the
/// hull empty, because a third may fill the dent.
constexpr double leastFill = 0.85, leastFillOfTwo = 0.5;
constexpr std::size_t mostInGroup = 16;

/// Corners nearer than this share of the group's size are one, and triangles that overlap less only touch.
constexpr double touchTolerance = 1e-6;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double areaOf(const Flat& triangle) {
    return cross(triangle[1] - triangle[0], triangle[2] - triangle[0]) / 2;
}

/// How far `b` lies beyond the farthest of a's sides; below zero where every side of a cuts into it. Two
/// triangles are apart when a side of one has the other on its far side (separating axes), and then at least
/// this far. Cheap, so it is asked before the exact distance.
double beyondSides(const Flat& a, const Flat& b) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d side = a[(i + 1) % 3] - a[i];
        double nearest = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d& corner : b)
            nearest = std::min(nearest, -cross(side, corner - a[i]));
        farthest = std::max(farthest, nearest / side.norm());
    }
    return farthest;
}

double distanceToSide(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d side = b - a;
    const double fraction = std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    return (point - a - fraction * side).norm();
}

/// Of triangles that do not overlap: then a corner of one is nearest to a side of the other.
double distanceBetween(const Flat& a, const Flat& b) {
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t side = 0; side < 3; ++side) {
            const std::size_t next = (side + 1) % 3;
            distance = std::min({distance, distanceToSide(a[corner], b[side], b[next]),
                                 distanceToSide(b[corner], a[side], a[next])});
        }
    return distance;
}

/// By the arc tangent of both products: an arc cosine loses half of its digits near 0 and 180°, where slivers
/// are.
double angleAt(const Flat& triangle, std::size_t corner) {
    const Eigen::Vector2d a = triangle[(corner + 1) % 3] - triangle[corner],
                          b = triangle[(corner + 2) % 3] - triangle[corner];
    return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

/// Each triangle is turned into the plane over a side that it shares with one that lies there already.
/// Nothing is stretched, so every triangle keeps its shape and all keep one scale, as [R 4.3.2.1] asks; a
/// parameterisation of larger pieces (least squares conformal maps) has fewer seams, but scales that differ
/// over each piece. Unfolded curved surface overlaps itself or gapes after some triangles, which bounds what
/// a group can be. Groups grow greedily: which triangles to put together so that the page is used best is a
/// question of packing, and the share of its convex hull that a group fills stands for it, since a convex
/// group packs well.
class Unfolder {
public:
    Unfolder(const TriangleMesh& mesh, const std::vector<PatchShape>& shapes, double clearance)
        : m_mesh(mesh), m_shapes(shapes), m_clearance(clearance), m_across(trianglesAcross(mesh.triangles)),
          m_angles(anglesAround()), m_isTaken(mesh.triangles.size(), false) {}

    /// Breadth first over the surface: groups next to groups leave few triangles alone between them.
    std::vector<UnfoldedGroup> unfoldAll(const Progress& progress) {
        std::queue<std::uint32_t> seeds;
        for (std::uint32_t first = 0; first < m_isTaken.size(); ++first) {
            seeds.push(first);
            for (; !seeds.empty(); seeds.pop()) {
                if (m_isTaken[seeds.front()]) continue;
                reportProgress(progress,
                               static_cast<double>(m_taken) / static_cast<double>(m_isTaken.size()));
                m_groups.push_back(grow(seeds.front()));
                for (const std::uint32_t triangle : m_groups.back().triangles)
                    for (const std::uint32_t next : m_across[triangle])
                        if (next != noIndex && !m_isTaken[next]) seeds.push(next);
            }
        }
        return std::move(m_groups);
    }

private:
    struct Candidate {
        std::uint32_t triangle;
        Flat corners;
    };

    bool isFlat(std::uint32_t triangle) const { return !(m_shapes[triangle].height > 0); }

    /// The triangle's corners in the mesh's order, wherever they lie.
    Flat flatten(std::uint32_t triangle) const {
        const PatchShape& shape = m_shapes[triangle];
        const Flat ofShape{{{0, 0}, {shape.base, 0}, {shape.foot, shape.height}}};
        Flat corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[(shape.firstCorner + i) % 3] = ofShape[i];
        return corners;
    }

    /// The triangle unfolded over its side `side`, which comes to lie from `start` to `end`. The ends are
    /// taken over bit by bit and not computed, so that neighbours share them exactly: the outline of a group
    /// and its seams are found by comparing numbers.
    Flat unfoldedOver(std::uint32_t triangle, std::size_t side, const Eigen::Vector2d& start,
                      const Eigen::Vector2d& end) const {
        const Flat flat = flatten(triangle);
        const Eigen::Vector2d &a = flat[side], &b = flat[(side + 1) % 3], &c = flat[(side + 2) % 3];
        const Eigen::Vector2d from = (b - a).normalized(), to = (end - start).normalized();
        const double cosine = from.dot(to), sine = cross(from, to);
        Flat corners;
        corners[side] = start;
        corners[(side + 1) % 3] = end;
        const Eigen::Vector2d offset = c - a;
        corners[(side + 2) % 3] = start + Eigen::Vector2d(cosine * offset.x() - sine * offset.y(),
                                                          sine * offset.x() + cosine * offset.y());
        return corners;
    }

    void add(UnfoldedGroup& group, const Candidate& candidate) {
        group.triangles.push_back(candidate.triangle);
        group.corners.push_back(candidate.corners);
        group.area += areaOf(candidate.corners);
        m_isTaken[candidate.triangle] = true;
        ++m_taken;
    }

    void addNeighbours(const Candidate& of, std::vector<Candidate>& candidates) const {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::uint32_t next = m_across[of.triangle][side];
            if (next == noIndex || m_isTaken[next] || isFlat(next)) continue;
            const std::uint32_t start = m_mesh.triangles[of.triangle][(side + 1) % 3];
            const Triangle& corners = m_mesh.triangles[next];
            const auto nextSide =
                static_cast<std::size_t>(std::find(corners.begin(), corners.end(), start) - corners.begin());
            candidates.push_back(
                {next, unfoldedOver(next, nextSide, of.corners[(side + 1) % 3], of.corners[side])});
        }
    }

    /// The angle that the surface takes around each vertex. Where the surface ends there is a gap between its
    /// two ends, which must not close in the plane: it counts for one radian at least.
    std::vector<double> anglesAround() const {
        constexpr double betweenEnds = 1; // radian
        std::vector<double> angles(m_mesh.vertices.size(), 0);
        for (std::uint32_t triangle = 0; triangle < m_mesh.triangles.size(); ++triangle) {
            if (isFlat(triangle)) continue;
            const Flat flat = flatten(triangle);
            for (std::size_t i = 0; i < 3; ++i) {
                angles[m_mesh.triangles[triangle][i]] += angleAt(flat, i);
                if (m_across[triangle][i] == noIndex) angles[m_mesh.triangles[triangle][i]] += betweenEnds;
            }
        }
        return angles;
    }

    /// Around a vertex of a saddle the surface takes more than a full turn. Unfolded, triangles with others
    /// between them on the surface may come to lie side by side there without overlapping, and a filter would
    /// mix them. So of the angle that is not yet laid at least half must be free in the plane. Around a
    /// vertex of less than a full turn this always holds.
    bool keepsItsAngles(const UnfoldedGroup& group, const Candidate& candidate) const {
        const double least = touchTolerance * std::sqrt(group.area);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = m_mesh.triangles[candidate.triangle][corner];
            double laid = angleAt(candidate.corners, corner);
            for (std::size_t i = 0; i < group.triangles.size(); ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    if (m_mesh.triangles[group.triangles[i]][j] == vertex &&
                        (group.corners[i][j] - candidate.corners[corner]).norm() < least)
                        laid += angleAt(group.corners[i], j);
            const double between = m_angles[vertex] - laid;
            if (between > touchTolerance && 2 * pi - laid < between / 2) return false;
        }
        return true;
    }

    /// Whether it neither overlaps the group nor comes too near to a triangle that it does not touch.
    bool hasRoom(const UnfoldedGroup& group, const Candidate& candidate) const {
        const double least = touchTolerance * std::sqrt(group.area);
        for (std::size_t i = 0; i < group.triangles.size(); ++i) {
            const Flat& other = group.corners[i];
            const double apart =
                std::max(beyondSides(other, candidate.corners), beyondSides(candidate.corners, other));
            if (apart < -least) return false;
            if (apart >= m_clearance || touch(candidate, group, i, least)) continue;
            if (distanceBetween(other, candidate.corners) < m_clearance) return false;
        }
        return true;
    }

    /// Whether a corner of both on the surface is one in the plane.
    bool touch(const Candidate& candidate, const UnfoldedGroup& group, std::size_t other,
               double least) const {
        const Triangle &a = m_mesh.triangles[candidate.triangle],
                       &b = m_mesh.triangles[group.triangles[other]];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                if (a[i] == b[j] && (candidate.corners[i] - group.corners[other][j]).norm() < least)
                    return true;
        return false;
    }

    /// A candidate with what the group's hull becomes, and how much of that the group fills.
    struct Choice {
        std::size_t candidate = 0;
        Polygon hull{};
        double fill = 0;
    };

    /// The hull of all is that of the old hull and three corners more: a group's inner corners are never
    /// looked at again.
    static Choice bestChoice(double area, const Polygon& hull, const std::vector<Candidate>& candidates) {
        Choice best;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const Flat& corners = candidates[i].corners;
            std::vector<Eigen::Vector2d> points = hull;
            points.insert(points.end(), corners.begin(), corners.end());
            Polygon grown = convexHull(std::move(points));
            const double fill = (area + areaOf(corners)) / esm::areaOf(grown);
            if (fill > best.fill) best = {i, std::move(grown), fill};
        }
        return best;
    }

    /// Around a seed, always on by the triangle that fills the convex hull best. One that has no room where
    /// it was unfolded is dropped; it may come back over another of its sides. What has a place in this group
    /// is dropped everywhere else, so that it is not laid twice.
    UnfoldedGroup grow(std::uint32_t seed) {
        UnfoldedGroup group;
        add(group, {seed, isFlat(seed) ? Flat{{{0, 0}, {0, 0}, {0, 0}}} : flatten(seed)});
        std::vector<Candidate> candidates;
        if (!isFlat(seed)) addNeighbours({seed, group.corners[0]}, candidates);
        Polygon hull = convexHull({group.corners[0].begin(), group.corners[0].end()});
        while (group.triangles.size() < mostInGroup) {
            Choice choice = bestChoice(group.area, hull, candidates);
            if (choice.fill < (group.triangles.size() > 1 ? leastFill : leastFillOfTwo)) break;
            const Candidate candidate = candidates[choice.candidate];
            candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(choice.candidate));
            if (!hasRoom(group, candidate) || !keepsItsAngles(group, candidate)) continue;
            add(group, candidate);
            hull = std::move(choice.hull);
            const auto isIn = [&](const Candidate& other) { return other.triangle == candidate.triangle; };
            candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isIn), candidates.end());
            addNeighbours(candidate, candidates);
        }
        return group;
    }

    const TriangleMesh& m_mesh;
    const std::vector<PatchShape>& m_shapes;
    double m_clearance;
    std::vector<Triangle> m_across;
    std::vector<double> m_angles; ///< around each vertex, radian
    std::vector<bool> m_isTaken;
    std::size_t m_taken = 0; ///< triangles
    std::vector<UnfoldedGroup> m_groups;
};

} // namespace

std::vector<UnfoldedGroup> unfold(const TriangleMesh& mesh, const std::vector<PatchShape>& shapes,
                                  double clearance, const Progress& progress) {
    return Unfolder(mesh, shapes, clearance).unfoldAll(progress);
}

} // namespace esm

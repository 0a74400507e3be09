#include "core/solid/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace esm {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

/// Cubes in space, as wide as triangles are, and which triangles' boxes each meets.
class TriangleGrid {
public:
    explicit TriangleGrid(const TriangleMesh& mesh) : m_mesh(mesh) {
        const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
        m_origin = box.min();
        double reach = 0;
        for (const Triangle& triangle : mesh.triangles)
            reach += boxOf(triangle).sizes().maxCoeff();
        const auto count = static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1));
        // No more than 2²⁰ cubes a side, so that a cube's number fits.
        m_width = std::max(2 * reach / count, box.sizes().maxCoeff() / 1e6);
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
            forEachCell(boxOf(mesh.triangles[i]),
                        [&](const Vector3i& cell) { m_entries.emplace_back(numberOf(cell), i); });
        std::sort(m_entries.begin(), m_entries.end());
        for (std::size_t i = 0; i < m_entries.size(); ++i)
            if (i == 0 || m_entries[i].first != m_entries[i - 1].first) m_starts.push_back(i);
        m_starts.push_back(m_entries.size());
    }

    std::size_t cellCount() const { return m_starts.size() - 1; }

    /// Visits every pair of triangles whose boxes meet, once over all cells.
    template<typename Visit> void forEachPair(std::size_t cell, const Visit& visit) const {
        for (std::size_t i = m_starts[cell]; i < m_starts[cell + 1]; ++i)
            for (std::size_t j = i + 1; j < m_starts[cell + 1]; ++j) {
                const std::uint32_t one = m_entries[i].second, other = m_entries[j].second;
                const Eigen::AlignedBox3d both =
                    boxOf(m_mesh.triangles[one]).intersection(boxOf(m_mesh.triangles[other]));
                // A pair that meets in several cells belongs to that of the first corner of its common box.
                if (!both.isEmpty() && numberOf(cellOf(both.min())) == m_entries[i].first) visit(one, other);
            }
    }

private:
    Eigen::AlignedBox3d boxOf(const Triangle& triangle) const {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t vertex : triangle)
            box.extend(m_mesh.vertices[vertex]);
        return box;
    }
    Vector3i cellOf(const Vector3d& point) const {
        return ((point - m_origin) / m_width).array().floor().cast<int>();
    }
    static std::uint64_t numberOf(const Vector3i& cell) {
        const auto part = [](int value) { return static_cast<std::uint64_t>(value); };
        return part(cell.x()) << 42 | part(cell.y()) << 21 | part(cell.z());
    }
    template<typename Visit> void forEachCell(const Eigen::AlignedBox3d& box, const Visit& visit) const {
        const Vector3i first = cellOf(box.min()), last = cellOf(box.max());
        for (int x = first.x(); x <= last.x(); ++x)
            for (int y = first.y(); y <= last.y(); ++y)
                for (int z = first.z(); z <= last.z(); ++z)
                    visit(Vector3i(x, y, z));
    }

    const TriangleMesh& m_mesh;
    Vector3d m_origin;
    double m_width = 1;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> m_entries; ///< cube and triangle, sorted
    std::vector<std::size_t> m_starts;
};

/// Six times the volume of the tetrahedron over a triangle.
double sixfold(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
    return (b - a).cross(c - a).dot(d - a);
}

/// Where a segment pierces the inside of a triangle. What lies within rounding of a corner, an edge or the
/// plane touches and does not pierce.
std::optional<Vector3d> piercing(const Vector3d& from, const Vector3d& to,
                                 const std::array<Vector3d, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const double above = sixfold(a, b, c, from), below = sixfold(a, b, c, to);
    const double size = std::max({(b - a).norm(), (c - a).norm(), (to - from).norm()});
    const double least = 1e-10 * size * size * size;
    if (std::min(std::abs(above), std::abs(below)) <= least || (above > 0) == (below > 0))
        return std::nullopt;
    const double sides[3] = {sixfold(from, to, a, b), sixfold(from, to, b, c), sixfold(from, to, c, a)};
    const bool isOneWay =
        std::min({sides[0], sides[1], sides[2]}) > least || std::max({sides[0], sides[1], sides[2]}) < -least;
    if (!isOneWay) return std::nullopt;
    return Vector3d(from + (to - from) * (above / (above - below)));
}

/// Where edges of one triangle pierce the other, each in turn until `isEnough(place)`. An edge at a corner of
/// both only touches.
template<typename IsEnough>
void pierce(const TriangleMesh& mesh, std::uint32_t oneNumber, std::uint32_t otherNumber,
            const IsEnough& isEnough) {
    const Triangle &one = mesh.triangles[oneNumber], &other = mesh.triangles[otherNumber];
    const std::array<Vector3d, 3> corners{mesh.vertices[other[0]], mesh.vertices[other[1]],
                                          mesh.vertices[other[2]]};
    const auto isShared = [&](std::uint32_t vertex) {
        return std::find(other.begin(), other.end(), vertex) != other.end();
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = one[i], to = one[(i + 1) % 3];
        if (isShared(from) || isShared(to)) continue;
        const auto place = piercing(mesh.vertices[from], mesh.vertices[to], corners);
        if (place && isEnough(*place)) return;
    }
}

std::optional<Vector3d> meeting(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other) {
    std::optional<Vector3d> first;
    pierce(mesh, one, other, [&](const Vector3d& place) {
        first = place;
        return true;
    });
    return first;
}

/// Those of one stretch of cells, then those of the next.
std::vector<MeetingTriangles> both(std::vector<MeetingTriangles> one,
                                   const std::vector<MeetingTriangles>& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

} // namespace

// Two triangles that intersect beyond touching have an edge of one through the inside of the other. Only
// those whose boxes meet are tried; a grid of cubes as wide as two triangles finds them in time linear in the
// surface.
std::vector<MeetingTriangles> meetingTriangles(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return {};
    const TriangleGrid grid(mesh);
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::size_t>(0, grid.cellCount(), 256), std::vector<MeetingTriangles>{},
        [&](const tbb::blocked_range<std::size_t>& cells, std::vector<MeetingTriangles> found) {
            for (std::size_t cell = cells.begin(); cell < cells.end(); ++cell)
                grid.forEachPair(cell, [&](std::uint32_t one, std::uint32_t other) {
                    auto place = meeting(mesh, one, other);
                    if (!place) place = meeting(mesh, other, one);
                    if (place) found.push_back({one, other, *place});
                });
            return found;
        },
        both);
}

std::vector<Vector3d> piercings(const TriangleMesh& mesh, std::uint32_t one, std::uint32_t other) {
    std::vector<Vector3d> places;
    const auto add = [&](const Vector3d& place) {
        places.push_back(place);
        return false;
    };
    pierce(mesh, one, other, add);
    pierce(mesh, other, one, add);
    return places;
}

SelfIntersections selfIntersectionsOf(const TriangleMesh& mesh) {
    const std::vector<MeetingTriangles> found = meetingTriangles(mesh);
    if (found.empty()) return {};
    return {found.size(), found.front().place};
}

} // namespace esm

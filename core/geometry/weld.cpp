#include "core/geometry/weld.h"

#include <cstring>
#include <unordered_map>

namespace esm {

namespace {

// By the bits of the coordinates, each mixed in by Knuth's multiplicative hashing (2⁶⁴ over the golden
// ratio). Coordinates of meshes often differ in few bits, and in the low ones not at all, where they came
// from single precision: the shift brings the high bits down to those by which a table is indexed.
struct PointHash {
    std::size_t operator()(const Eigen::Vector3d& point) const {
        std::uint64_t hash = 0;
        for (const double coordinate : point) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &coordinate, sizeof bits);
            hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// −0 and 0 are equal but hash differently.
Eigen::Vector3d withoutNegativeZero(const Eigen::Vector3d& point) {
    return point.array() + 0.0;
}

/// What an exporter wrote once for each corner has the same bits each time. One look into a table for each
/// point finds it, and nothing is joined that was meant to lie apart.
std::vector<std::uint32_t> weldEqual(const std::vector<Eigen::Vector3d>& points) {
    std::unordered_map<Eigen::Vector3d, std::uint32_t, PointHash> firstAt;
    firstAt.reserve(points.size());
    std::vector<std::uint32_t> representatives(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        representatives[i] = firstAt.try_emplace(withoutNegativeZero(points[i]), i).first->second;
    return representatives;
}

/// Representatives by cell of a grid as wide as the distance: a near point lies in the same or an adjoining
/// cell. Only points that stand for themselves are in it. Were welded ones, too, a row of points each near
/// the last would come together in one place, however long it is.
class WeldGrid {
public:
    WeldGrid(const std::vector<Eigen::Vector3d>& points, double distance)
        : m_points(points), m_distance(distance) {}

    std::uint32_t representative(std::uint32_t index) {
        const Eigen::Vector3d cell = cellOf(m_points[index]);
        std::uint32_t nearest = index;
        double best = m_distance * m_distance;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const auto found = m_cells.find(withoutNegativeZero(cell + Eigen::Vector3d(x, y, z)));
                    if (found == m_cells.end()) continue;
                    for (const std::uint32_t other : found->second) {
                        const double squared = (m_points[other] - m_points[index]).squaredNorm();
                        if (squared < best || (squared == best && other < nearest)) {
                            best = squared;
                            nearest = other;
                        }
                    }
                }
        if (nearest == index) m_cells[cell].push_back(index);
        return nearest;
    }

private:
    Eigen::Vector3d cellOf(const Eigen::Vector3d& point) const {
        return withoutNegativeZero((point / m_distance).array().floor());
    }

    const std::vector<Eigen::Vector3d>& m_points;
    double m_distance;
    std::unordered_map<Eigen::Vector3d, std::vector<std::uint32_t>, PointHash> m_cells;
};

} // namespace

// Points come in the order of the file, and each is looked for among those before it. The result hangs on
// that order and on nothing else; time is linear as long as few representatives share a cell, as they are
// apart by the distance.
std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3d>& points, double distance) {
    if (distance <= 0) return weldEqual(points);
    WeldGrid grid(points, distance);
    std::vector<std::uint32_t> representatives(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        representatives[i] = grid.representative(i);
    return representatives;
}

} // namespace esm

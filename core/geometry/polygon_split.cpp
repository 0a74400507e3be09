#include "core/geometry/polygon_split.h"

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Twice the area of a triangle, positive when it turns counter-clockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return cross(b - a, c - b);
}

/// The corners seen along the polygon's area normal, so that it turns counter-clockwise; all at one point
/// when the polygon has no area. The normal is the sum over all corners (Newell's), not that of three of
/// them: polygons of files are not quite flat, and three corners may lie on a line or at a notch.
std::vector<Eigen::Vector2d> projected(const std::vector<Eigen::Vector3d>& vertices,
                                       const std::vector<std::uint32_t>& polygon) {
    const Eigen::Vector3d& origin = vertices[polygon[0]];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += (vertices[polygon[i]] - origin).cross(vertices[polygon[i + 1]] - origin);
    if (normal.isZero(0)) return std::vector<Eigen::Vector2d>(polygon.size(), Eigen::Vector2d::Zero());
    const Eigen::Vector3d across = normal.unitOrthogonal();
    const Eigen::Vector3d up = normal.normalized().cross(across);
    std::vector<Eigen::Vector2d> corners;
    corners.reserve(polygon.size());
    for (const std::uint32_t vertex : polygon)
        corners.emplace_back(across.dot(vertices[vertex] - origin), up.dot(vertices[vertex] - origin));
    return corners;
}

/// Twice the area below which three corners count as lying on one line. Coordinates are rounded to 10⁻¹⁶ of
/// the polygon's extent, and a product of two of them has that relative to the extent's square. 10⁻¹² is some
/// thousands of such roundings.
double negligibleTurn(const std::vector<Eigen::Vector2d>& corners) {
    double squaredExtent = 0;
    for (const Eigen::Vector2d& corner : corners)
        squaredExtent = std::max(squaredExtent, corner.squaredNorm());
    return 1e-12 * squaredExtent;
}

/// No corner turns right, and each triangle of the fan from the first corner has an area.
bool isConvexFan(const std::vector<Eigen::Vector2d>& corners) {
    const std::size_t count = corners.size();
    const double negligible = negligibleTurn(corners);
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d& next = corners[(i + 1) % count];
        if (turn(corners[i], next, corners[(i + 2) % count]) < -negligible) return false;
        if (i > 0 && i + 1 < count && turn(corners[0], corners[i], next) <= negligible) return false;
    }
    return true;
}

/// What is left of a polygon while its ears are cut off. An ear is a corner whose triangle holds no other
/// corner; a simple polygon of more than three corners always has two (Meisters 1975), so that cutting does
/// not get stuck, and it needs no point that the polygon has not. Every test looks at all corners; faces of
/// organs have few. Corners that lie where the ear's own do, as at the two sides of a slit, are no hindrance.
class EarCutter {
public:
    explicit EarCutter(const std::vector<Eigen::Vector2d>& corners)
        : m_corners(corners), m_negligible(negligibleTurn(corners)), m_left(corners.size()) {
        std::iota(m_left.begin(), m_left.end(), 0);
    }

    /// Corner indices of each triangle.
    std::vector<Triangle> cut() {
        std::vector<Triangle> triangles;
        std::size_t at = 0, refused = 0;
        while (m_left.size() > 3) {
            // A polygon that crosses itself may have no ear at all: then any corner goes.
            if (!isEar(at) && ++refused < m_left.size()) {
                at = (at + 1) % m_left.size();
                continue;
            }
            triangles.push_back(triangleAt(at));
            m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(at));
            at %= m_left.size();
            refused = 0;
        }
        triangles.push_back(triangleAt(1));
        return triangles;
    }

private:
    Triangle triangleAt(std::size_t middle) const {
        const std::size_t count = m_left.size();
        return {m_left[(middle + count - 1) % count], m_left[middle], m_left[(middle + 1) % count]};
    }

    bool isEar(std::size_t middle) const {
        const Triangle ear = triangleAt(middle);
        const Eigen::Vector2d &a = m_corners[ear[0]], &b = m_corners[ear[1]], &c = m_corners[ear[2]];
        if (turn(a, b, c) <= m_negligible) return false;
        return std::none_of(m_left.begin(), m_left.end(), [&](std::uint32_t other) {
            const Eigen::Vector2d& p = m_corners[other];
            if (p == a || p == b || p == c) return false;
            return std::min({turn(a, b, p), turn(b, c, p), turn(c, a, p)}) >= -m_negligible;
        });
    }

    const std::vector<Eigen::Vector2d>& m_corners;
    double m_negligible;
    std::vector<std::uint32_t> m_left;
};

std::vector<Triangle> fan(std::size_t cornerCount) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 1; i + 1 < cornerCount; ++i)
        triangles.push_back({0, i, i + 1});
    return triangles;
}

} // namespace

// A convex polygon may be split as a fan, in time in proportion to its corners. Only the others are worth
// cutting ears.
std::vector<Triangle> splitPolygon(const std::vector<Eigen::Vector3d>& vertices,
                                   const std::vector<std::uint32_t>& polygon) {
    if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
    const std::vector<Eigen::Vector2d> corners = projected(vertices, polygon);
    std::vector<Triangle> triangles = isConvexFan(corners) ? fan(corners.size()) : EarCutter(corners).cut();
    for (Triangle& triangle : triangles)
        for (std::uint32_t& corner : triangle)
            corner = polygon[corner];
    return triangles;
}

} // namespace esm

#include "core/texture/atlas/charts/chart_border.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

double crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A point on a side: how far it is along from the side's beginning, 0 to 1.
struct OnSide {
    double share;
    Eigen::Vector2d point;
};

OnSide nearestOn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& to) {
    const Eigen::Vector2d side = b - a;
    const double square = side.squaredNorm();
    const double share = square > 0 ? std::clamp((to - a).dot(side) / square, 0.0, 1.0) : 0;
    return {share, a + share * side};
}

class Border {
public:
    Border(const PlanePoints& points, double clearance) : m_points(points), m_clearance(clearance) {
        m_along.reserve(points.size() + 1);
        m_along.push_back(0);
        for (std::size_t i = 0; i < points.size(); ++i)
            m_along.push_back(m_along.back() + (end(i) - points[i]).norm());
    }

    bool isClear() const {
        for (std::size_t i = 0; i < m_points.size(); ++i)
            if (!opens(i)) return false;
        return arePairsClear();
    }

private:
    const Eigen::Vector2d& end(std::size_t side) const { return m_points[(side + 1) % m_points.size()]; }

    /// Whether the two sides at a point leave an angle outside of them.
    bool opens(std::size_t point) const {
        const Eigen::Vector2d& corner = m_points[point];
        const Eigen::Vector2d &before = m_points[(point + m_points.size() - 1) % m_points.size()],
                              &after = end(point);
        const Eigen::Vector2d in = corner - before, out = after - corner;
        if (!(in.norm() > 0 && out.norm() > 0)) return false;
        const double turn = std::atan2(crossOf(in, out), in.dot(out)); // to the left, into the chart
        const double leastOpening = 2 * std::asin(1 / mostDetour);
        return M_PI + turn > leastOpening;
    }

    bool arePairsClear() const {
        std::vector<std::pair<std::int64_t, std::uint32_t>> cells = cellsOfSides();
        std::sort(cells.begin(), cells.end());
        for (std::size_t first = 0; first < cells.size();) {
            std::size_t last = first;
            while (last < cells.size() && cells[last].first == cells[first].first)
                ++last;
            for (std::size_t i = first; i < last; ++i)
                for (std::size_t j = i + 1; j < last; ++j)
                    if (!isPairClear(cells[i].second, cells[j].second)) return false;
            first = last;
        }
        return true;
    }

    /// Sides that come near each other are in one cell of a grid at least.
    std::vector<std::pair<std::int64_t, std::uint32_t>> cellsOfSides() const {
        const double mean = m_along.back() / static_cast<double>(m_points.size());
        const double size = std::max(m_clearance, 2 * mean), reach = m_clearance / 2 + 1e-9 * mean;
        constexpr std::int64_t columns = std::int64_t{1} << 31;
        std::vector<std::pair<std::int64_t, std::uint32_t>> cells;
        cells.reserve(2 * m_points.size());
        for (std::uint32_t side = 0; side < m_points.size(); ++side) {
            const double low = std::min(m_points[side].y(), end(side).y()) - reach,
                         high = std::max(m_points[side].y(), end(side).y()) + reach;
            const auto cellOf = [&](double at) { return static_cast<std::int64_t>(std::floor(at / size)); };
            for (std::int64_t y = cellOf(low); y <= cellOf(high); ++y) {
                const double row = static_cast<double>(y) * size;
                const auto [left, right] = spanWithin(side, row - reach, row + size + reach);
                for (std::int64_t x = cellOf(left - reach); x <= cellOf(right + reach); ++x)
                    cells.emplace_back(y * columns + x, side);
            }
        }
        return cells;
    }

    /// From the least x to the greatest of what of a side lies between two heights.
    std::pair<double, double> spanWithin(std::size_t side, double low, double high) const {
        const Eigen::Vector2d &a = m_points[side], &b = end(side);
        const double rise = b.y() - a.y();
        const auto at = [&](double y) {
            const double share = rise != 0 ? std::clamp((y - a.y()) / rise, 0.0, 1.0) : 0;
            return a.x() + share * (b.x() - a.x());
        };
        if (rise == 0) return std::minmax({a.x(), b.x()});
        return std::minmax({at(low), at(high)});
    }

    bool cross(std::size_t one, std::size_t other) const {
        const Eigen::Vector2d &a = m_points[one], &b = end(one), &c = m_points[other], &d = end(other);
        const double c1 = crossOf(b - a, c - a), c2 = crossOf(b - a, d - a);
        const double a1 = crossOf(d - c, a - c), a2 = crossOf(d - c, b - c);
        return c1 * c2 <= 0 && a1 * a2 <= 0 && !(c1 == 0 && c2 == 0 && a1 == 0 && a2 == 0);
    }

    /// @param one the lower number
    bool isPairClear(std::size_t one, std::size_t other) const {
        const std::size_t count = m_points.size();
        if (one == other || other == one + 1 || (one == 0 && other + 1 == count)) return true;
        return !cross(one, other) && isClearAlong(one, other) && isClearAlong(other, one);
    }

    /// Whether a side is clear of another where it is nearest to it and where it comes within the clearance.
    /// Between these places detour and distance change so evenly that none is worse by more than a hundredth.
    bool isClearAlong(std::size_t side, std::size_t other) const {
        const Eigen::Vector2d &a = m_points[side], &b = end(side);
        const Eigen::Vector2d &c = m_points[other], &d = end(other);
        const auto distanceAt = [&](double share) {
            const Eigen::Vector2d point = a + share * (b - a);
            return (nearestOn(c, d, point).point - point).norm();
        };
        double nearest = distanceAt(0) < distanceAt(1) ? 0 : 1;
        for (const Eigen::Vector2d* point : {&c, &d}) {
            const double share = nearestOn(a, b, *point).share;
            if (distanceAt(share) < distanceAt(nearest)) nearest = share;
        }
        if (distanceAt(nearest) >= m_clearance) return distanceAt(nearest) > 0;
        const auto clipped = [&](double farther) {
            if (distanceAt(farther) < m_clearance) return farther;
            double within = nearest;
            for (int halvings = 0; halvings < 20; ++halvings) {
                const double middle = (within + farther) / 2;
                (distanceAt(middle) < m_clearance ? within : farther) = middle;
            }
            return within;
        };
        return isClearAt(side, nearest, other) && isClearAt(side, clipped(0), other) &&
               isClearAt(side, clipped(1), other);
    }

    bool isClearAt(std::size_t side, double share, std::size_t other) const {
        const Eigen::Vector2d &a = m_points[side], &b = end(side);
        const Eigen::Vector2d &c = m_points[other], &d = end(other);
        const Eigen::Vector2d point = a + share * (b - a);
        const OnSide nearest = nearestOn(c, d, point);
        const Eigen::Vector2d between = nearest.point - point;
        // What is outside lies to the right of a side: between two that face each other.
        if (!(crossOf(b - a, between) < 0 && crossOf(d - c, -between) < 0)) return between.norm() > 0;
        const double along = std::abs(placeOn(side, share) - placeOn(other, nearest.share));
        return std::min(along, m_along.back() - along) <= mostDetour * between.norm();
    }

    double placeOn(std::size_t side, double share) const {
        return m_along[side] + share * (m_along[side + 1] - m_along[side]);
    }

    const PlanePoints& m_points;
    double m_clearance;
    std::vector<double> m_along; ///< from the first point to each, and all around
};

} // namespace

bool keepsClear(const PlanePoints& border, double clearance) {
    return Border(border, clearance).isClear();
}

} // namespace esm

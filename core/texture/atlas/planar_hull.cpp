#include "core/texture/atlas/planar_hull.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

double crossProduct(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

TurnedRectangle rectangleAlong(const Eigen::Vector2d& direction, const Polygon& hull) {
    const Eigen::Vector2d across(-direction.y(), direction.x());
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Eigen::Vector2d& corner : hull) {
        const Eigen::Array2d turned(direction.dot(corner), across.dot(corner));
        low = low.min(turned);
        high = high.max(turned);
    }
    return {direction, low, high.x() - low.x(), high.y() - low.y()};
}

} // namespace

/// The monotone chain of Andrew (1979): points from left to right give the lower chain, back from right to
/// left the upper one; a corner that does not turn left is dropped. A turn of 0 is dropped too, so that no
/// corner lies on a side and points that are there twice count once.
Polygon convexHull(std::vector<Eigen::Vector2d> points) {
    std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    Polygon hull;
    const auto addTo = [&](std::size_t start, const Eigen::Vector2d& point) {
        while (hull.size() >= start + 2 &&
               crossProduct(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const Eigen::Vector2d& point : points)
        addTo(0, point);
    const std::size_t lower = hull.size() - (hull.empty() ? 0 : 1);
    for (auto point = points.rbegin(); point != points.rend(); ++point)
        if (point != points.rbegin()) addTo(lower, *point);
    if (hull.size() > 1) hull.pop_back();
    return hull;
}

double areaOf(const Polygon& polygon) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        area += crossProduct(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]) / 2;
    return area;
}

/// One side of the smallest rectangle lies along a side of the hull (Freeman and Shapira 1975), so only these
/// directions are tried. Each is measured at all corners: the hull of a group has at most 18 of them, that of
/// a chart some hundred, for which rotating calipers would be longer and hardly faster. Strictly smaller ones
/// alone take over, so that of equal rectangles the first is taken on every machine.
TurnedRectangle smallestRectangle(const Polygon& hull) {
    TurnedRectangle smallest = rectangleAlong({1, 0}, hull);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector2d side = hull[(i + 1) % hull.size()] - hull[i];
        if (!(side.norm() > 0)) continue;
        const TurnedRectangle rectangle = rectangleAlong(side.normalized(), hull);
        if (rectangle.length * rectangle.height < smallest.length * smallest.height) smallest = rectangle;
    }
    if (smallest.length >= smallest.height) return smallest;
    return rectangleAlong({-smallest.direction.y(), smallest.direction.x()}, hull);
}

} // namespace esm

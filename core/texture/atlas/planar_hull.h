#pragma once

#include <Eigen/Core>

#include <vector>

namespace esm {

using Polygon = std::vector<Eigen::Vector2d>; ///< counter-clockwise

/// The smallest convex polygon around points, without corners on its sides.
Polygon convexHull(std::vector<Eigen::Vector2d> points);

double areaOf(const Polygon& polygon);

/// A rectangle around points, turned so that its longer side lies along `direction`.
struct TurnedRectangle {
    Eigen::Vector2d direction; ///< of length 1
    Eigen::Vector2d corner;    ///< the lowest along `direction` and across it, in the turned directions
    double length, height;     ///< length ≥ height
};

/// The smallest one around a convex polygon, one side of which it shares.
TurnedRectangle smallestRectangle(const Polygon& hull);

} // namespace esm

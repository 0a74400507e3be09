#include "core/geometry/ellipsoid.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

/// Far more than Newton's rule ever took, from spheres to plates a billion times as wide as thick.
constexpr int mostRefinements = 100;

Vector3d inOwnAxes(const Ellipsoid& ellipsoid, const Vector3d& point) {
    return ellipsoid.orientation.conjugate() * (point - ellipsoid.centre);
}

/// 0/0, of a place without extent along a flat axis, is nothing.
double share(double part, double whole) {
    return part == 0 ? 0 : part / whole;
}

/// The nearest point of the surface to y outside has the coordinates e²·y/(t + e²), e the radii, for the t >
/// 0 at which it fulfils the surface's equation, Σ (e·y/(t + e²))² = 1 (Hart 1994). From the nearest point x
/// to y leads a normal of the surface, y − x = t·x/e² axis by axis, which gives that form. The distance along
/// the ray to the centre, which is often taken instead, is many times too large over the flat sides of a flat
/// ellipsoid: a soft rim would be next to nothing there.
double parameterOfNearest(const Vector3d& radii, const Vector3d& place) {
    const Vector3d scaled = radii.cwiseProduct(place), squares = radii.cwiseAbs2();
    // None of the terms is above 1 there. From below, Newton's rule on what falls and is convex never
    // oversteps, so that it has arrived once rounding no longer lets it rise.
    double t = std::max(0.0, (scaled - squares).maxCoeff());
    for (int i = 0; i < mostRefinements; ++i) {
        double value = -1, slope = 0;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const double term = share(scaled[axis], t + squares[axis]);
            value += term * term;
            slope -= 2 * share(term * term, t + squares[axis]);
        }
        const double next = t - share(value, slope);
        if (!(next > t)) break;
        t = next;
    }
    return t;
}

} // namespace

// Divided by its radii the ellipsoid is the unit ball.
bool contains(const Ellipsoid& ellipsoid, const Vector3d& point) {
    return inOwnAxes(ellipsoid, point).cwiseQuotient(ellipsoid.radii).squaredNorm() <= 1;
}

// Mirrored into the octant where all coordinates are positive: an ellipsoid is symmetric, and of each sign
// only one case is then left.
double distanceOutside(const Ellipsoid& ellipsoid, const Vector3d& point) {
    if (contains(ellipsoid, point)) return 0;
    // In units of the largest extent, whose squares neither overflow nor vanish.
    const Vector3d place = inOwnAxes(ellipsoid, point).cwiseAbs();
    const double unit = std::max(ellipsoid.radii.maxCoeff(), place.maxCoeff());
    const Vector3d radii = ellipsoid.radii / unit, outside = place / unit;
    const double t = parameterOfNearest(radii, outside);
    Vector3d offset;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        offset[axis] = share(t * outside[axis], t + radii[axis] * radii[axis]);
    return unit * offset.norm();
}

std::vector<std::string> validate(const Ellipsoid& ellipsoid) {
    std::vector<std::string> problems = fieldProblems(ellipsoid);
    if (!(std::abs(ellipsoid.orientation.norm() - 1) < 1e-6))
        problems.emplace_back("the orientation must be a rotation");
    return problems;
}

} // namespace esm

#pragma once

namespace esm {

/// Of forces that are left, over those that are sought: then tissue is at rest.
inline constexpr double balanced = 1e-6;
/// The same where rounding lets nothing more be gained, or after many steps down a valley with next to no
/// slope, as of a net that shears freely or is slack: the force is known long before the place is.
inline constexpr double nearlyBalanced = 1e-4;
inline constexpr int mostDownhillSteps = 1000;

/// Whether a search that has gone so many steps downhill may end, with so much left over.
constexpr bool isAtRest(double left, double tolerance, int steps) {
    constexpr int many = 50;
    return left <= tolerance || (steps >= many && left <= nearlyBalanced);
}

} // namespace esm

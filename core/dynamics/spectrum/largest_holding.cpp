#include "core/dynamics/spectrum/largest_holding.h"

#include "core/dynamics/spectrum/stability_search.h"

#include <algorithm>
#include <cmath>

namespace esm {

// Doubles until the condition fails, then halves the ratio between the two: steps of a nanosecond and of a
// second are found at the same cost.
double largestHolding(double stable, double cap, double tolerance, const std::function<bool(double)>& holds) {
    if (stable >= cap || (std::isfinite(cap) && holds(cap))) return cap;
    // In uniform tissue the first guess is the limit itself.
    if (!holds((1 + tolerance) * stable)) return stable;
    double unstable = cap;
    for (int doubling = 0; doubling < 60 && 2 * stable < cap; ++doubling) {
        if (!holds(2 * stable)) {
            unstable = 2 * stable;
            break;
        }
        stable *= 2;
    }
    if (!std::isfinite(unstable)) return noStepLimit;
    while (unstable > (1 + tolerance) * stable) {
        const double middle = std::sqrt(stable * unstable);
        (holds(middle) ? stable : unstable) = middle;
    }
    return stable;
}

} // namespace esm

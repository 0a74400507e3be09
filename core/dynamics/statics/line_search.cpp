#include "core/dynamics/statics/line_search.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double promisedPart = 1e-4; ///< of what the slope promises, at least gained (Armijo 1966)
constexpr double unspentPart = 0.5;   ///< of the slope, at most left (Wolfe 1969)
/// Of a value: a difference as small may be rounding (Hager and Zhang 2005).
constexpr double doubtfulPart = 1e-6;
constexpr int mostTries = 60;

/// Where the slope is 0 if it changes evenly from one place to the other.
double evenZero(double low, double slopeAtLow, double high, double slopeAtHigh) {
    return low + (high - low) * slopeAtLow / (slopeAtLow - slopeAtHigh);
}

} // namespace

// A sheet that nothing presses resists next to nothing across, and a step of Newton's method goes far beyond
// the place where it meets the finger: there the slope jumps up within a ten-thousandth of the way. Halving
// the way until the potential is lower would stop short of that place again and again, and the method would
// never learn what lies behind it. So the slope is followed to where it is spent, in turns by the line
// through two slopes and by halves.
//
// Close to balance, what a step still gains is less than the rounding of the potential, long before the
// forces are balanced: all of a soft sheet's potential comes of lengths that change by a millionth. There the
// slope alone decides, which rounding leaves sharp.
std::optional<double> lowerPart(const OnWay& start, const std::function<OnWay(double part)>& at) {
    const double doubtful = doubtfulPart * std::abs(start.value), unspent = -unspentPart * start.slope;
    double low = 0, high = 1, slopeAtLow = start.slope, slopeAtHigh = 0, part = 1;
    for (int tries = 0; tries < mostTries; ++tries) {
        const auto [value, slope] = at(part);
        const double gained = start.value - value;
        const bool isLower = gained >= -promisedPart * part * start.slope || std::abs(gained) <= doubtful;
        if (isLower && slope <= unspent && (slope >= -unspent || part == 1)) return part;
        if (isLower && slope < 0) {
            low = part;
            slopeAtLow = slope;
        } else {
            high = part;
            slopeAtHigh = slope;
        }
        const bool isByLine = tries % 2 == 0 && slopeAtHigh > 0;
        part = isByLine ? evenZero(low, slopeAtLow, high, slopeAtHigh) : (low + high) / 2;
    }
    if (low > 0) return low;
    return {};
}

} // namespace esm

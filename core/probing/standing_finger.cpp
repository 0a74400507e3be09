#include "core/probing/standing_finger.h"

#include "core/probing/time_curves.h"

#include <algorithm>
#include <cmath>

namespace esm {

// Tissue is thrown ahead of a finger that comes fast: its dampers bear the motion, then the finger stands
// alone until what it threw comes back. Neither is relaxation. The way down therefore begins at the largest
// force that there is once the finger stands, and not where it came to its depth.
StandingFinger standingFinger(const TimeCurve& relaxation) {
    const double full = relaxation.end.depth;
    // The first point at the full depth still bears the motion of the step that led to it.
    const auto arrived = std::find_if(relaxation.points.begin(), relaxation.points.end(),
                                      [&](const TimedPress& point) { return point.depth >= full; });
    const std::vector<TimedPress> points(std::next(arrived), relaxation.points.end());
    const auto largest =
        std::max_element(points.begin(), points.end(),
                         [](const TimedPress& a, const TimedPress& b) { return a.force < b.force; });
    return {points, *largest};
}

bool hasNextToNoWay(const TimeCurve& relaxation) {
    const double end = relaxation.end.force;
    return std::abs(standingFinger(relaxation).largest.force - end) <= leastWay * std::abs(end);
}

std::optional<double> fallenAt(const TimeCurve& relaxation) {
    if (!relaxation.timeConstant) return std::nullopt;
    return standingFinger(relaxation).largest.time + *relaxation.timeConstant;
}

} // namespace esm

#pragma once

#include "core/fuzzy/fuzzy_system.h"

namespace esm {

/// What a rule leaves of a conclusion's set: straight between start, rise, fall and end, 0 outside.
struct ImpliedSet {
    double start, rise, fall, end;
    double height;               ///< from rise to fall
    double riseWidth, fallWidth; ///< over which the degree would go from 0 to 1 and back
};

/// `degree` is that of the rule, above 0.
inline ImpliedSet implied(const Trapezoid& set, double degree, TNorm implication) {
    const double riseWidth = set.b - set.a, fallWidth = set.d - set.c;
    switch (implication) {
    case TNorm::Product: // scales
        return {set.a, set.b, set.c, set.d, degree, riseWidth / degree, fallWidth / degree};
    case TNorm::BoundedDifference: // sinks, what is below 0 is cut off
        return {set.b - degree * riseWidth,
                set.b,
                set.c,
                set.c + degree * fallWidth,
                degree,
                riseWidth,
                fallWidth};
    default: // cuts off what is above the degree
        return {set.a,    set.a + degree * riseWidth, set.d - degree * fallWidth, set.d, degree, riseWidth,
                fallWidth};
    }
}

/// Whether some of its area, or the point that it is, lies within the variable's range.
inline bool reachesInto(const FuzzyVariable& variable, const ImpliedSet& set) {
    return set.start == set.end ? set.end >= variable.minimum && set.start <= variable.maximum
                                : set.end > variable.minimum && set.start < variable.maximum;
}

} // namespace esm

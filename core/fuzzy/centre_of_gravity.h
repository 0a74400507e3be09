#pragma once

#include "core/fuzzy/implied_set.h"

#include <optional>
#include <vector>

namespace esm {

/// A straight piece of a set over one interval.
struct SetPiece {
    double left, right; ///< degrees at the interval's ends
};

/// Working memory, so that the outputs of one inference share it.
struct OutputSets {
    std::vector<double> degrees; ///< per term, where only the highest counts
    std::vector<ImpliedSet> sets;
    std::vector<double> breaks;   ///< where a set bends, in rising order
    std::vector<SetPiece> pieces; ///< of the sets over the interval at hand
};

/// Exact centre of gravity, over the variable's range, of what the aggregation makes of `work.sets`; empty
/// where there are none. Precondition: each of the sets reaches into the range.
std::optional<double> centreOfGravity(const FuzzyVariable& variable, TConorm aggregation, OutputSets& work);

} // namespace esm

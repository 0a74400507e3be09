#pragma once

#include "core/fuzzy/centre_of_gravity.h"

#include <vector>

namespace esm {

/// A corner of a drawn set.
struct OutlinePoint {
    double x, degree;
};
/// From left to right, straight between neighbours; two at the same place where the set jumps.
using Outline = std::vector<OutlinePoint>;

/// Of one set, within the variable's range: from 0 up and back to 0. A set that is a single point stands as a
/// line of its height.
Outline outlineOf(const ImpliedSet& set, const FuzzyVariable& variable);

/// Of what the aggregation makes of `work.sets`, from one end of the variable's range to the other. Exact
/// under the maximum and the bounded sum; under the probabilistic sum, which is curved, sampled so that a
/// straight part is no longer than a 400th of the range. Points do not show beside sets that have area, as
/// they have no weight there.
Outline aggregatedOutline(const FuzzyVariable& variable, TConorm aggregation, OutputSets& work);

} // namespace esm

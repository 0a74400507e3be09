#pragma once

#include "core/fuzzy/centre_of_gravity.h"

#include <optional>
#include <vector>

namespace esm {

/// To what degree a condition holds, 0 to 1; empty where it asks for an input that is missing.
std::optional<double> degreeOf(const FuzzyCondition& condition, const FuzzySystem& system,
                               const std::vector<std::optional<double>>& inputs);

/// To what degree a rule fires whose condition holds to that degree; an unknown condition does not fire.
double firingOf(const FuzzyRule& rule, std::optional<double> condition);

/// Memory for the most sets that an output can have.
OutputSets workingMemory(const FuzzySystem& system);

/// What a rule that fires to a degree leaves of an output's term; none where it leaves nothing in its range.
std::optional<ImpliedSet> concludedSet(const FuzzySystem& system, const FuzzyProposition& conclusion,
                                       double degree);

/// What the rules leave of an output's terms. Under the maximum the rule with the highest degree covers the
/// others that conclude the same; under sums every conclusion counts.
/// @param firing degree per rule
void collectSets(OutputSets& work, const FuzzySystem& system, std::size_t output,
                 const std::vector<double>& firing);

} // namespace esm

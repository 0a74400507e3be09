#pragma once

#include "core/fuzzy/rule_facts.h"

namespace esm {

/// Values of the inputs for which no rule that concludes an output fires: it then has no value.
struct EmptyCases {
    /// By input: the values for which the output is empty whatever the other inputs are.
    std::vector<CellSet> decided;
    /// All others, no two of which meet, the largest share of the inputs' ranges first. A box of no input is
    /// everything: then no rule ever fires for the output, and nothing else is told.
    std::vector<ValueBox> combined;
};

/// Cells of an input looked up in a rule's box, for all outputs of a system together: a tenth of a second.
inline constexpr std::size_t mostCaseWork = 2'000'000;

/// As exact as RuleReach::where(): what is said to be empty is so for certain. None where it is not known of
/// a rule, or where the cases are too many. Precondition: the facts are of the reach's system.
/// @param work done so far, and more afterwards; nothing is found beyond `mostCaseWork`
std::optional<EmptyCases> emptyCases(const std::vector<RuleFacts>& rules, std::size_t output,
                                     const RuleReach& reach, std::size_t& work);

} // namespace esm

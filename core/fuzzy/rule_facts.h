#pragma once

#include "core/fuzzy/rule_reach.h"

#include <map>
#include <set>

namespace esm {

using TermSet = std::set<std::size_t>;

/// What is looked up of a rule again and again when it is compared with others.
struct RuleFacts {
    std::string normalForm;                           ///< of its condition
    std::set<std::size_t> inputs;                     ///< that it asks for
    std::map<std::size_t, TermSet> concluded;         ///< by output
    std::optional<std::vector<ValueBox>> above, full; ///< see RuleReach::where
    bool canFire = true;                              ///< also where that is not known
};

/// Precondition: the system is valid, and the one that the reach is of.
std::vector<RuleFacts> factsOfRules(const FuzzySystem& system, RuleReach& reach);

/// The values of an input's range for which every rule that asks for the input has the degree 0, whatever
/// values of their ranges the other inputs have: exact between the corners of the terms, as far as
/// RuleReach is. The whole range where no rule asks for it; none where it is not known of a rule.
/// @param cells of the input
std::vector<ValueRange> uncoveredRanges(const std::vector<RuleFacts>& rules, std::size_t input,
                                        const std::vector<ValueCell>& cells);

} // namespace esm

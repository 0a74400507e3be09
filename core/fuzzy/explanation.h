#pragma once

#include "core/fuzzy/aggregated_outline.h"

#include <optional>
#include <vector>

namespace esm {

/// One "variable IS term" of a condition.
struct PropositionDegree {
    FuzzyProposition proposition;
    std::optional<double> degree; ///< before any NOT; empty where the input is missing
};

/// Why a rule fires as strongly as it does.
struct RuleExplanation {
    std::vector<PropositionDegree> propositions; ///< of the condition, in the order of its words
    std::optional<double> condition;             ///< its degree; empty where it asks for a missing input
    double firing = 0; ///< the condition's degree times the rule's weight, as infer() tells it
};

/// One per rule. Preconditions as of infer().
std::vector<RuleExplanation> explainRules(const FuzzySystem& system,
                                          const std::vector<std::optional<double>>& inputs);

/// What a rule concludes of an output.
struct ConcludedSet {
    std::size_t rule, term;
    double degree;   ///< to which the rule fires
    Outline outline; ///< what that leaves of the term's set
};

/// Why an output has its value.
struct OutputExplanation {
    std::vector<ConcludedSet> sets; ///< of the rules that fire, in their order
    Outline aggregated;             ///< what they make together
    std::optional<double> value;    ///< its centre of gravity, as infer() tells it; empty without sets
};

/// @param firing degree per rule, as infer() and explainRules() tell it
OutputExplanation explainOutput(const FuzzySystem& system, std::size_t output,
                                const std::vector<double>& firing);

} // namespace esm

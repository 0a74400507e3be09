#pragma once

#include "core/fuzzy/rule_text.h"

#include <optional>

namespace esm {

/// A rule as a row of a table: a cell per input and per output. What cells cannot show stays text. A row may
/// be unfinished.
struct RuleRow {
    /// "term" or "NOT term".
    struct Choice {
        std::size_t term;
        bool isNegated;
    };

    std::string unread; ///< the whole line, where it is no rule; then nothing else is set
    /// Per input, where the condition is propositions joined by AND, at most one of each input; an input that
    /// is not asked for has none.
    std::vector<std::optional<Choice>> inputs;
    std::string condition; ///< the text of any other condition, else empty
    /// Per output the term, where the rule concludes one at most of each output.
    std::vector<std::optional<std::size_t>> outputs;
    std::string conclusions; ///< the text of any others, else empty
    double weight = 1;
};

/// Reads a line as a row. Other than rules, rows may have no condition or no conclusion: "IF THEN y IS low".
/// Preconditions: the line is not blank, the system is valid but for its rules.
RuleRow rowOf(const FuzzySystem& system, const std::string& line);

/// The line that says what a row says.
std::string lineOf(const FuzzySystem& system, const RuleRow& row);

} // namespace esm

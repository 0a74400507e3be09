#pragma once

#include "core/fuzzy/rule_text.h"

namespace esm {

/// A line that cannot be read as a rule, or has none of what rules may have.
struct UnreadRule {
    std::size_t line;    ///< from 0, empty lines included
    std::size_t number;  ///< of the rule, from 1
    std::string message; ///< with the column and what was expected
    RuleMistake mistake;
};

/// What a text of one rule per line says.
struct RulesReading {
    std::vector<FuzzyRule> rules;
    std::vector<UnreadRule> unread;
    std::string problem; ///< of the text as a whole, of which then nothing was read; else empty
};

/// The rules of a system, one per line, without a line end behind the last.
std::string rulesText(const FuzzySystem& system);

/// Reads one rule per line; empty lines stand for nothing. The system says which variables and terms there
/// are; its own rules do not count.
RulesReading readRules(const FuzzySystem& system, const std::vector<std::string>& lines);

/// Keywords, names and brackets that may stand behind the beginning of a rule. None where the beginning
/// cannot be read.
std::vector<std::string> wordsThatFit(const FuzzySystem& system, const std::string& beginning);

/// Whether a line has no word.
bool isBlank(const std::string& line);

} // namespace esm

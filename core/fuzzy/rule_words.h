#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace esm {

struct RuleWord {
    std::string text;
    std::size_t begin;  ///< its first byte in the rule
    std::size_t column; ///< of its first letter, from 1
    std::size_t length; ///< in letters
};

/// The words of a rule; brackets are words of their own. The last one is empty and stands for the end.
std::vector<RuleWord> ruleWords(const std::string& text);

} // namespace esm

#pragma once

#include <array>
#include <string>

namespace esm {

/// The words of rules that no variable and no term may be named after.
inline constexpr std::array ruleKeywords{"IF", "IS", "NOT", "AND", "OR", "THEN", "WITH"};

/// Whether a word of a rule is the keyword, in any case. `keyword` is in capitals.
bool isKeyword(const std::string& word, const char* keyword);

/// Whether it is any of them.
bool isKeyword(const std::string& word);

inline constexpr std::size_t longestName = 500; ///< bytes, of a variable or a term

/// Why a text cannot be the name of a variable or a term; empty where it can. A name stands as one word in a
/// rule.
std::string nameProblem(const std::string& name);

/// Brackets are words of their own, whether or not spaces surround them.
inline bool isBracket(char c) {
    return c == '(' || c == ')';
}

} // namespace esm

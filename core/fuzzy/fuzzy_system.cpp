#include "core/fuzzy/fuzzy_system.h"

#include "core/fuzzy/keywords.h"
#include "core/support/joined.h"

#include <algorithm>

namespace esm {

/// A name stands in rules as one word, between others and beside brackets. What the parser would take for two
/// words, for a bracket or for a keyword could be given but never be used.
std::string nameProblem(const std::string& name) {
    const auto endsWord = [](char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == 127 || isBracket(c);
    };
    if (name.empty()) return "the name is missing";
    if (name.size() > longestName)
        return "a name may have " + std::to_string(longestName) + " bytes, this one has " +
               std::to_string(name.size());
    if (std::any_of(name.begin(), name.end(), endsWord))
        return "a name is one word without spaces and brackets; join words with _";
    if (isKeyword(name))
        return joined({ruleKeywords.begin(), ruleKeywords.end()}) + " are words of rules, not names";
    return {};
}

/// A trapezoid [R 2.47]. Its flanks are reached only where a ≤ x < b or c < x ≤ d, so that an upright one (a
/// = b, c = d) is never divided by; its corner belongs to the core. NaN is in no set.
double membership(const Trapezoid& set, double x) {
    if (!(x >= set.a && x <= set.d)) return 0;
    if (x < set.b) return (x - set.a) / (set.b - set.a);
    if (x > set.c) return (set.d - x) / (set.d - set.c);
    return 1;
}

} // namespace esm

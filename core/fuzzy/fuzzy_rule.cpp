#include "core/fuzzy/fuzzy_rule.h"

#include <algorithm>
#include <utility>

namespace esm {

/// It is asked before anything goes through a condition recursively, and is recursive itself: so it turns
/// back at the level that is asked for, however deep a file has nested.
bool isDeeperThan(int levels, const FuzzyCondition& condition) {
    if (levels <= 0) return true;
    return std::any_of(condition.parts.begin(), condition.parts.end(),
                       [&](const FuzzyCondition& part) { return isDeeperThan(levels - 1, part); });
}

FuzzyCondition negation(FuzzyCondition condition) {
    FuzzyCondition result{{}, FuzzyCondition::Kind::Not, {}};
    result.parts.push_back(std::move(condition));
    return result;
}

FuzzyCondition conjunction(std::vector<FuzzyCondition> conditions) {
    return {{}, FuzzyCondition::Kind::And, std::move(conditions)};
}

FuzzyCondition disjunction(std::vector<FuzzyCondition> conditions) {
    return {{}, FuzzyCondition::Kind::Or, std::move(conditions)};
}

} // namespace esm

#include "core/fuzzy/fuzzy_rule.h"

#include <algorithm>
#include <utility>

namespace esm {

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

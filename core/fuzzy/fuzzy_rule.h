#pragma once

#include <cstddef>
#include <vector>

namespace esm {

/// "variable IS term", both as indices into the system's lists.
struct FuzzyProposition {
    std::size_t variable = 0;
    std::size_t term = 0;

    bool operator==(const FuzzyProposition&) const = default;
};

/// What must hold for a rule to fire: "variable IS term" over the inputs, or NOT, AND, OR of conditions.
struct FuzzyCondition {
    enum class Kind { Is, Not, And, Or };

    FuzzyProposition proposition; ///< of Is
    Kind kind = Kind::Is;
    std::vector<FuzzyCondition> parts = {}; ///< one of Not, two or more of And and of Or, none of Is

    bool operator==(const FuzzyCondition&) const = default;
};

/// How deep conditions may be nested, the outermost counted. It bounds the recursion of all that goes through
/// one.
inline constexpr int deepestCondition = 100;

/// Does not look further down than `levels`.
bool isDeeperThan(int levels, const FuzzyCondition& condition);

FuzzyCondition negation(FuzzyCondition condition);
FuzzyCondition conjunction(std::vector<FuzzyCondition> conditions); ///< of two or more
FuzzyCondition disjunction(std::vector<FuzzyCondition> conditions); ///< of two or more

/// IF the condition holds THEN every conclusion does. The condition speaks of inputs, conclusions of outputs.
struct FuzzyRule {
    FuzzyCondition condition;
    std::vector<FuzzyProposition> conclusions;
    double weight = 1; ///< 0 to 1, by which the condition's degree is multiplied

    bool operator==(const FuzzyRule&) const = default;
};

} // namespace esm

#pragma once

#include "core/support/fields.h"

#include <algorithm>
#include <array>

namespace esm {

/// How degrees of what must hold together are combined: a t-norm. [R B.1] These three and their duals are the
/// pairs that FCL (IEC 61131-7) has words for, so that systems go to files of others and back.
enum class TNorm { Minimum, Product, BoundedDifference };
template<>
inline constexpr auto wordsOf<TNorm> =
    std::array{Word{TNorm::Minimum, "minimum"}, Word{TNorm::Product, "product"},
               Word{TNorm::BoundedDifference, "bounded-difference"}};

/// How degrees of alternatives are combined: the t-conorm dual to the t-norm at the same place. [R B.2]
enum class TConorm { Maximum, ProbabilisticSum, BoundedSum };
template<>
inline constexpr auto wordsOf<TConorm> =
    std::array{Word{TConorm::Maximum, "maximum"}, Word{TConorm::ProbabilisticSum, "probabilistic-sum"},
               Word{TConorm::BoundedSum, "bounded-sum"}};

/// What the words of rules and the steps of inference compute; the defaults are Mamdani's. [R 2.48, 2.49]
struct FuzzyNorms {
    TNorm conjunction = TNorm::Minimum;     ///< AND
    TConorm disjunction = TConorm::Maximum; ///< OR
    TNorm implication = TNorm::Minimum;     ///< what a rule's degree leaves of a conclusion's set
    TConorm aggregation = TConorm::Maximum; ///< what the sets of several rules make together

    bool operator==(const FuzzyNorms&) const = default;
};
template<>
inline constexpr auto
    fieldsOf<FuzzyNorms> = fieldTable(field("conjunction", &FuzzyNorms::conjunction).whenSet(),
                                      field("disjunction", &FuzzyNorms::disjunction).whenSet(),
                                      field("implication", &FuzzyNorms::implication).whenSet(),
                                      field("aggregation", &FuzzyNorms::aggregation).whenSet());

/// Of the same family: NOT (a AND b) is then NOT a OR NOT b, by De Morgan's laws.
TConorm dual(TNorm norm);
TNorm dual(TConorm norm);

/// Whether AND and OR are.
bool areDual(const FuzzyNorms& norms);

/// Of two degrees, each 0 to 1.
inline double combined(TNorm norm, double a, double b) {
    switch (norm) {
    case TNorm::Product:
        return a * b;
    case TNorm::BoundedDifference: // Łukasiewicz
        return std::max(0.0, a + b - 1);
    default:
        return std::min(a, b);
    }
}

inline double combined(TConorm norm, double a, double b) {
    switch (norm) {
    case TConorm::ProbabilisticSum:
        return a + b * (1 - a);
    case TConorm::BoundedSum: // Łukasiewicz
        return std::min(1.0, a + b);
    default:
        return std::max(a, b);
    }
}

} // namespace esm

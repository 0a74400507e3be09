#pragma once

#include "core/fuzzy/fuzzy_rule.h"
#include "core/fuzzy/norms.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Trapezoidal fuzzy set a ≤ b ≤ c ≤ d [R 2.47]. `a = b` or `c = d` is a shoulder at the end of a domain.
struct Trapezoid {
    double a = 0, b = 0, c = 0, d = 0;

    bool operator==(const Trapezoid&) const = default;
};

/// One without area, all four corners at one place. It is a shoulder nowhere, not even at an end of a domain.
inline bool isSinglePoint(const Trapezoid& set) {
    return set.a == set.d;
}

/// Degree, 0 to 1, to which `x` belongs to the set. [R 2.47]
double membership(const Trapezoid& set, double x);

struct FuzzyTerm {
    std::string name;
    Trapezoid set;

    bool operator==(const FuzzyTerm&) const = default;
};

inline constexpr std::size_t longestUnit = 500; ///< bytes, of a variable

/// A named variable: a range and its ordered partition into named sets.
struct FuzzyVariable {
    std::string name;
    double minimum = 0, maximum = 1;
    std::vector<FuzzyTerm> terms; ///< in the order of the partition
    std::string unit = {};        ///< of its values, for people; may be empty

    bool operator==(const FuzzyVariable&) const = default;
};

/// A Mamdani fuzzy system. The order of variables and terms is the order of sliders and partitions.
struct FuzzySystem {
    std::string name;
    std::string description; ///< what it is for, a sentence or two in plain words; may be empty
    std::string note;        ///< where it comes from, for people
    std::vector<FuzzyVariable> inputs;
    std::vector<FuzzyVariable> outputs;
    std::vector<FuzzyRule> rules;
    FuzzyNorms norms;

    bool operator==(const FuzzySystem&) const = default;
};
/// Variables stand in files by their names, rules as text: see `fuzzy_file.cpp`.
template<>
inline constexpr auto fieldsOf<FuzzySystem> =
    fieldTable(field("name", &FuzzySystem::name).mayBeAbsent(),
               field("description", &FuzzySystem::description).whenSet(),
               field("note", &FuzzySystem::note).mayBeAbsent(), field("inputs", &FuzzySystem::inputs),
               field("outputs", &FuzzySystem::outputs), field("norms", &FuzzySystem::norms).whenSet(),
               field("rules", &FuzzySystem::rules));

/// More than any expert reads; the time of an inference grows with the square of the conclusions.
inline constexpr std::size_t mostFuzzyRules = 2000;
inline constexpr std::size_t mostFuzzyConclusions = 4000; ///< of all rules together
inline constexpr std::size_t mostFuzzyWords = 2000;       ///< inputs, outputs, terms of one of them

/// What to say of more rules than there may be.
std::string tooManyRules(std::size_t count);

/// A variable of a system, or one of its terms, by index.
struct FuzzyPart {
    enum class List { Inputs, Outputs };
    List list;
    std::size_t variable;
    std::optional<std::size_t> term = {};
};

struct FuzzyProblem {
    std::string text;              ///< with the place in words: "inputs.zeal.terms.much: …"
    std::optional<FuzzyPart> part; ///< that it is of; none of rules and of what is missing
};

/// Every problem of a system: names missing or twice, empty ranges and partitions, corners out of order,
/// rules that name what is not there, that are nested too deeply or too many. Empty when the system can be
/// evaluated.
std::vector<FuzzyProblem> problemsOf(const FuzzySystem& system);
std::vector<std::string> validate(const FuzzySystem& system); ///< their texts

} // namespace esm

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace esm {

/// Trapezoidal fuzzy set a ≤ b ≤ c ≤ d [R 2.47]. `a = b` or `c = d` is a shoulder at the end of a domain.
struct Trapezoid {
    double a = 0, b = 0, c = 0, d = 0;
};

/// Degree, 0 to 1, to which `x` belongs to the set. [R 2.47]
double membership(const Trapezoid& set, double x);

struct FuzzyTerm {
    std::string name;
    Trapezoid set;
};

/// A named variable: a range and its ordered partition into named sets.
struct FuzzyVariable {
    std::string name;
    double minimum = 0, maximum = 1;
    std::vector<FuzzyTerm> terms; ///< in the order of the partition
};

/// "variable IS term", both as indices into the system's lists.
struct FuzzyProposition {
    std::size_t variable = 0;
    std::size_t term = 0;
};

/// IF every condition THEN every conclusion. Conditions speak of inputs, conclusions of outputs.
struct FuzzyRule {
    std::vector<FuzzyProposition> conditions;
    std::vector<FuzzyProposition> conclusions;
};

/// A Mamdani fuzzy system. The order of variables and terms is the order of sliders and partitions.
struct FuzzySystem {
    std::string name;
    std::string description; ///< what it is for, a sentence or two in plain words; may be empty
    std::string note;        ///< where it comes from, for people
    std::vector<FuzzyVariable> inputs;
    std::vector<FuzzyVariable> outputs;
    std::vector<FuzzyRule> rules;
};

/// Every problem of a system: names missing or twice, empty ranges and partitions, corners out of order,
/// rules that name what is not there. Empty when the system can be evaluated.
std::vector<std::string> validate(const FuzzySystem& system);

/// "IF consistency IS soft THEN spring_const IS small AND viscosity IS large"
std::string ruleText(const FuzzySystem& system, const FuzzyRule& rule);

/// Reads a rule in the form that ruleText() writes; keywords in any case.
/// @throws InvalidModel naming the column and what was expected
FuzzyRule parseRule(const FuzzySystem& system, const std::string& text);

} // namespace esm

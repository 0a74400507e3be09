#include "core/fuzzy/fuzzy_system.h"

#include "core/fuzzy/keywords.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

/// A name stands as one word in a rule.
void checkName(Problems& problems, const std::string& place, const std::string& name) {
    const auto isSpaceOrControl = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == 127; };
    if (name.empty())
        problems.push_back(place + ": the name is missing");
    else if (std::any_of(name.begin(), name.end(), isSpaceOrControl))
        problems.push_back(place + ": a name is one word without spaces; join words with _");
    else if (isKeyword(name))
        problems.push_back(place + ": IF, IS, AND and THEN are words of rules, not names");
}

std::string listed(std::initializer_list<double> numbers) {
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ", ") + numberText(number);
    return text;
}

/// Beyond it the square of a width overflows.
std::string upToLargest() {
    return " up to " + numberText(largestNumber);
}

void checkCorners(Problems& problems, const std::string& place, const Trapezoid& set) {
    const auto isBounded = [](double corner) { return std::abs(corner) <= largestNumber; };
    if (!(isBounded(set.a) && isBounded(set.b) && isBounded(set.c) && isBounded(set.d)))
        problems.push_back(place + ": the corners must be finite numbers" + upToLargest());
    else if (!(set.a <= set.b && set.b <= set.c && set.c <= set.d))
        problems.push_back(place + ": the corners must rise, got " + listed({set.a, set.b, set.c, set.d}));
}

void checkVariable(Problems& problems, const std::string& place, const FuzzyVariable& variable) {
    checkName(problems, place, variable.name);
    const bool hasRange = variable.minimum >= -largestNumber && variable.maximum <= largestNumber &&
                          variable.minimum < variable.maximum;
    if (!hasRange)
        problems.push_back(place + ".range: must be two finite numbers" + upToLargest() +
                           ", the smaller first, got " + listed({variable.minimum, variable.maximum}));
    if (variable.terms.empty()) problems.push_back(place + ".terms: there must be at least one");
    std::set<std::string> names;
    for (const FuzzyTerm& term : variable.terms) {
        const std::string termPlace = place + ".terms." + term.name;
        checkName(problems, termPlace, term.name);
        checkCorners(problems, termPlace, term.set);
        if (!names.insert(term.name).second) problems.push_back(termPlace + ": the name is there twice");
    }
}

/// A conclusion outside its variable's range would have nothing to take the centre of gravity of; one that
/// reaches the range in its end point alone, neither area nor the weight of a point.
void checkOutputSets(Problems& problems, const std::string& place, const FuzzyVariable& output) {
    for (const FuzzyTerm& term : output.terms) {
        const auto& [a, b, c, d] = term.set;
        const bool isPoint = a == d;
        const bool isOutside =
            isPoint ? d < output.minimum || a > output.maximum : d <= output.minimum || a >= output.maximum;
        if (isOutside)
            problems.push_back(place + ".terms." + term.name + ": lies outside the output's range");
    }
}

void checkPropositions(Problems& problems, const std::string& place,
                       const std::vector<FuzzyProposition>& list,
                       const std::vector<FuzzyVariable>& variables) {
    if (list.empty()) problems.push_back(place + ": there must be at least one");
    for (const FuzzyProposition& proposition : list)
        if (proposition.variable >= variables.size() ||
            proposition.term >= variables[proposition.variable].terms.size())
            problems.push_back(place + ": speaks of a variable or term that is not there");
}

} // namespace

double membership(const Trapezoid& set, double x) {
    if (!(x >= set.a && x <= set.d)) return 0;
    if (x < set.b) return (x - set.a) / (set.b - set.a);
    if (x > set.c) return (set.d - x) / (set.d - set.c);
    return 1;
}

std::vector<std::string> validate(const FuzzySystem& system) {
    Problems problems;
    std::set<std::string> names;
    const auto checkVariables = [&](const char* list, const std::vector<FuzzyVariable>& variables) {
        if (variables.empty()) problems.push_back(std::string(list) + ": there must be at least one");
        for (const FuzzyVariable& variable : variables) {
            const std::string place = std::string(list) + "." + variable.name;
            checkVariable(problems, place, variable);
            if (!names.insert(variable.name).second) problems.push_back(place + ": the name is there twice");
        }
    };
    checkVariables("inputs", system.inputs);
    checkVariables("outputs", system.outputs);
    for (const FuzzyVariable& output : system.outputs)
        checkOutputSets(problems, "outputs." + output.name, output);
    for (std::size_t i = 0; i < system.rules.size(); ++i) {
        const std::string place = "rules[" + std::to_string(i) + "]";
        checkPropositions(problems, place + ", conditions", system.rules[i].conditions, system.inputs);
        checkPropositions(problems, place + ", conclusions", system.rules[i].conclusions, system.outputs);
    }
    return problems;
}

} // namespace esm

#include "core/fuzzy/fuzzy_system.h"

#include "core/fuzzy/implied_set.h"
#include "core/fuzzy/keywords.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

void checkName(Problems& problems, const std::string& place, const std::string& name) {
    if (const std::string problem = nameProblem(name); !problem.empty())
        problems.push_back(place + ": " + problem);
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

bool isControl(char c) {
    return static_cast<unsigned char>(c) < ' ' || c == 127;
}

void checkVariable(Problems& problems, const std::string& place, const FuzzyVariable& variable) {
    checkName(problems, place, variable.name);
    const bool hasRange = variable.minimum >= -largestNumber && variable.maximum <= largestNumber &&
                          variable.minimum < variable.maximum;
    if (!hasRange)
        problems.push_back(place + ".range: must be two finite numbers" + upToLargest() +
                           ", the smaller first, got " + listed({variable.minimum, variable.maximum}));
    if (std::any_of(variable.unit.begin(), variable.unit.end(), isControl))
        problems.push_back(place + ".unit: must be one line of text");
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
    for (const FuzzyTerm& term : output.terms)
        if (!reachesInto(output, implied(term.set, 1, TNorm::Minimum)))
            problems.push_back(place + ".terms." + term.name + ": lies outside the output's range");
}

bool isThere(const FuzzyProposition& proposition, const std::vector<FuzzyVariable>& variables) {
    return proposition.variable < variables.size() &&
           proposition.term < variables[proposition.variable].terms.size();
}

constexpr const char* notThere = ": speaks of a variable or term that is not there";

/// Precondition: the condition is not nested too deeply.
void checkCondition(Problems& problems, const std::string& place, const FuzzyCondition& condition,
                    const std::vector<FuzzyVariable>& inputs) {
    using Kind = FuzzyCondition::Kind;
    const std::size_t parts = condition.parts.size();
    const bool isJoined = condition.kind == Kind::And || condition.kind == Kind::Or;
    const bool isWhole = isJoined ? parts >= 2 : parts == (condition.kind == Kind::Not ? 1 : 0);
    if (!isWhole) problems.push_back(place + ": AND and OR join two conditions or more, NOT takes one");
    if (condition.kind == Kind::Is && !isThere(condition.proposition, inputs))
        problems.push_back(place + notThere);
    for (const FuzzyCondition& part : condition.parts)
        checkCondition(problems, place, part, inputs);
}

void checkRule(Problems& problems, const std::string& place, const FuzzyRule& rule,
               const FuzzySystem& system) {
    if (isDeeperThan(deepestCondition, rule.condition))
        problems.push_back(place + ", condition: is nested deeper than " + std::to_string(deepestCondition));
    else
        checkCondition(problems, place + ", condition", rule.condition, system.inputs);
    if (rule.conclusions.empty()) problems.push_back(place + ", conclusions: there must be at least one");
    for (const FuzzyProposition& conclusion : rule.conclusions)
        if (!isThere(conclusion, system.outputs)) problems.push_back(place + ", conclusions" + notThere);
    if (!(rule.weight >= 0 && rule.weight <= 1))
        problems.push_back(place + ", weight: must be a number from 0 to 1, got " + numberText(rule.weight));
}

void checkRules(Problems& problems, const FuzzySystem& system) {
    if (system.rules.size() > mostFuzzyRules) {
        problems.push_back(tooManyRules(system.rules.size()));
        return;
    }
    std::size_t conclusions = 0;
    for (const FuzzyRule& rule : system.rules)
        conclusions += rule.conclusions.size();
    if (conclusions > mostFuzzyConclusions)
        problems.push_back("rules: there are " + std::to_string(conclusions) +
                           " conclusions in all; a system may have " + std::to_string(mostFuzzyConclusions));
    for (std::size_t i = 0; i < system.rules.size(); ++i)
        checkRule(problems, "rules[" + std::to_string(i) + "]", system.rules[i], system);
}

} // namespace

bool operator==(const Trapezoid& one, const Trapezoid& other) {
    return one.a == other.a && one.b == other.b && one.c == other.c && one.d == other.d;
}

bool operator==(const FuzzyTerm& one, const FuzzyTerm& other) {
    return one.name == other.name && one.set == other.set;
}

bool operator==(const FuzzyVariable& one, const FuzzyVariable& other) {
    return one.name == other.name && one.minimum == other.minimum && one.maximum == other.maximum &&
           one.terms == other.terms && one.unit == other.unit;
}

bool operator==(const FuzzySystem& one, const FuzzySystem& other) {
    return one.name == other.name && one.description == other.description && one.note == other.note &&
           one.inputs == other.inputs && one.outputs == other.outputs && one.rules == other.rules &&
           one.norms == other.norms;
}

std::string nameProblem(const std::string& name) {
    const auto endsWord = [](char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == 127 || isBracket(c);
    };
    if (name.empty()) return "the name is missing";
    if (std::any_of(name.begin(), name.end(), endsWord))
        return "a name is one word without spaces and brackets; join words with _";
    if (isKeyword(name))
        return joined({ruleKeywords.begin(), ruleKeywords.end()}) + " are words of rules, not names";
    return {};
}

double membership(const Trapezoid& set, double x) {
    if (!(x >= set.a && x <= set.d)) return 0;
    if (x < set.b) return (x - set.a) / (set.b - set.a);
    if (x > set.c) return (set.d - x) / (set.d - set.c);
    return 1;
}

std::string tooManyRules(std::size_t count) {
    return "rules: there are " + std::to_string(count) + "; a system may have " +
           std::to_string(mostFuzzyRules);
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
    checkRules(problems, system);
    return problems;
}

} // namespace esm

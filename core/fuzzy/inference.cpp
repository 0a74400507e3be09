#include "core/fuzzy/inference.h"

#include "core/fuzzy/centre_of_gravity.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace esm {

namespace {

/// Empty where it asks for an input that is missing.
std::optional<double> degreeOf(const FuzzyCondition& condition, const FuzzySystem& system,
                               const std::vector<std::optional<double>>& inputs) {
    using Kind = FuzzyCondition::Kind;
    if (condition.kind == Kind::Is) {
        const auto [variable, term] = condition.proposition;
        const std::optional<double>& value = inputs[variable];
        if (!value || std::isnan(*value)) return std::nullopt;
        return membership(system.inputs[variable].terms[term].set, *value);
    }
    std::optional<double> degree = degreeOf(condition.parts.front(), system, inputs);
    if (!degree) return std::nullopt;
    if (condition.kind == Kind::Not) return 1 - *degree;
    for (auto part = condition.parts.begin() + 1; part != condition.parts.end(); ++part) {
        const std::optional<double> next = degreeOf(*part, system, inputs);
        if (!next) return std::nullopt;
        degree = condition.kind == Kind::And ? combined(system.norms.conjunction, *degree, *next)
                                             : combined(system.norms.disjunction, *degree, *next);
    }
    return degree;
}

std::vector<double> firingDegrees(const FuzzySystem& system,
                                  const std::vector<std::optional<double>>& inputs) {
    std::vector<double> degrees;
    degrees.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules)
        degrees.push_back(rule.weight * degreeOf(rule.condition, system, inputs).value_or(0));
    return degrees;
}

/// Enough for the most sets that an output can have.
OutputSets workingMemory(const FuzzySystem& system) {
    std::size_t terms = 0, conclusions = 0;
    for (const FuzzyVariable& output : system.outputs)
        terms = std::max(terms, output.terms.size());
    for (const FuzzyRule& rule : system.rules)
        conclusions += rule.conclusions.size();
    const std::size_t sets = system.norms.aggregation == TConorm::Maximum ? terms : conclusions;
    OutputSets work;
    work.degrees.reserve(terms);
    work.sets.reserve(sets);
    work.breaks.reserve(4 * sets);
    work.pieces.reserve(sets);
    return work;
}

void addSet(OutputSets& work, const FuzzyVariable& output, std::size_t term, double degree,
            TNorm implication) {
    if (!(degree > 0)) return;
    const ImpliedSet set = implied(output.terms[term].set, degree, implication);
    if (reachesInto(output, set)) work.sets.push_back(set);
}

/// What the rules leave of an output's terms. Under the maximum the rule with the highest degree covers the
/// others that conclude the same; under sums every conclusion counts.
void collectSets(OutputSets& work, const FuzzySystem& system, std::size_t output,
                 const std::vector<double>& firing) {
    const FuzzyVariable& variable = system.outputs[output];
    const bool everyOneCounts = system.norms.aggregation != TConorm::Maximum;
    work.sets.clear();
    work.degrees.assign(variable.terms.size(), 0);
    for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
        for (const auto [concluded, term] : system.rules[rule].conclusions) {
            if (concluded != output) continue;
            if (everyOneCounts)
                addSet(work, variable, term, firing[rule], system.norms.implication);
            else
                work.degrees[term] = std::max(work.degrees[term], firing[rule]);
        }
    for (std::size_t term = 0; term < work.degrees.size(); ++term)
        addSet(work, variable, term, work.degrees[term], system.norms.implication);
}

} // namespace

InferenceResult infer(const FuzzySystem& system, const std::vector<std::optional<double>>& inputs) {
    InferenceResult result;
    result.firing = firingDegrees(system, inputs);
    result.outputs.reserve(system.outputs.size());
    OutputSets work = workingMemory(system);
    for (std::size_t output = 0; output < system.outputs.size(); ++output) {
        collectSets(work, system, output, result.firing);
        result.outputs.push_back(centreOfGravity(system.outputs[output], system.norms.aggregation, work));
    }
    return result;
}

std::vector<std::optional<double>> orderedInputs(const FuzzySystem& system, const NamedValues& values) {
    std::vector<std::optional<double>> ordered(system.inputs.size());
    std::vector<std::string> problems;
    for (const auto& [name, value] : values) {
        const auto input = std::find_if(system.inputs.begin(), system.inputs.end(),
                                        [&name = name](const FuzzyVariable& v) { return v.name == name; });
        if (input == system.inputs.end())
            problems.push_back("there is no input \"" + name + "\"; the inputs are " +
                               joinedNames(system.inputs));
        else if (!std::isfinite(value))
            problems.push_back("the input " + name + " is not a finite number");
        else
            ordered[static_cast<std::size_t>(input - system.inputs.begin())] = value;
    }
    if (!problems.empty()) throw InvalidModel(problems);
    return ordered;
}

std::string inWords(const FuzzyVariable& variable, double value) {
    std::vector<std::pair<double, const std::string*>> degrees;
    for (const FuzzyTerm& term : variable.terms)
        if (const double degree = membership(term.set, value); degree >= 0.005)
            degrees.emplace_back(degree, &term.name);
    std::stable_sort(degrees.begin(), degrees.end(),
                     [](const auto& p, const auto& q) { return p.first > q.first; });
    std::string words;
    for (const auto& [degree, name] : degrees) {
        char number[16];
        std::snprintf(number, sizeof number, "%.2f", degree);
        if (!words.empty()) words += ", ";
        words.append(*name).append(" ").append(number);
    }
    return words.empty() ? "none" : words;
}

} // namespace esm

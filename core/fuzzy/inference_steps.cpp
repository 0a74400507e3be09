#include "core/fuzzy/inference_steps.h"

#include <algorithm>
#include <cmath>

namespace esm {

/// From the inside out. A missing input makes everything around it unknown, even where the other parts would
/// decide, as OR with a 1: a rule about what nobody has said must not fire by chance.
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

double firingOf(const FuzzyRule& rule, std::optional<double> condition) {
    return rule.weight * condition.value_or(0);
}

/// A set under the maximum for each term, under a sum for each conclusion (collectSets()), with four bends
/// each. Memory is then asked for once, and not within each output of each inference.
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

/// A set that lies outside the output's range, cut down as it is, has nothing to take the centre of gravity
/// of.
std::optional<ImpliedSet> concludedSet(const FuzzySystem& system, const FuzzyProposition& conclusion,
                                       double degree) {
    if (!(degree > 0)) return std::nullopt;
    const FuzzyVariable& output = system.outputs[conclusion.variable];
    const ImpliedSet set = implied(output.terms[conclusion.term].set, degree, system.norms.implication);
    return reachesInto(output, set) ? std::optional(set) : std::nullopt;
}

/// Under the maximum the highest degree of a term hides all lower ones of the same term, since cutting,
/// scaling and sinking a set all grow with the degree: one set for each term is enough, however many rules
/// conclude it. A sum counts every conclusion.
void collectSets(OutputSets& work, const FuzzySystem& system, std::size_t output,
                 const std::vector<double>& firing) {
    const auto add = [&](std::size_t term, double degree) {
        if (const auto set = concludedSet(system, {output, term}, degree)) work.sets.push_back(*set);
    };
    const bool everyOneCounts = system.norms.aggregation != TConorm::Maximum;
    work.sets.clear();
    work.degrees.assign(system.outputs[output].terms.size(), 0);
    for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
        for (const auto [concluded, term] : system.rules[rule].conclusions) {
            if (concluded != output) continue;
            if (everyOneCounts)
                add(term, firing[rule]);
            else
                work.degrees[term] = std::max(work.degrees[term], firing[rule]);
        }
    for (std::size_t term = 0; term < work.degrees.size(); ++term)
        add(term, work.degrees[term]);
}

} // namespace esm

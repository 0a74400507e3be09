#include "core/fuzzy/explanation.h"

#include "core/fuzzy/inference_steps.h"

namespace esm {

namespace {

/// Words of a condition in the order in which they stand, as the explanation lists them. Their degrees are
/// told before any NOT: the word is what the user sees in the partition.
void addPropositions(RuleExplanation& explanation, const FuzzyCondition& condition, const FuzzySystem& system,
                     const std::vector<std::optional<double>>& inputs) {
    if (condition.kind == FuzzyCondition::Kind::Is)
        explanation.propositions.push_back({condition.proposition, degreeOf(condition, system, inputs)});
    for (const FuzzyCondition& part : condition.parts)
        addPropositions(explanation, part, system, inputs);
}

} // namespace

/// infer() needs the degrees of whole conditions; here those of their words are asked for as well. An
/// explanation is wanted now and then, an inference with every move of a slider: so inference keeps nothing
/// for it.
std::vector<RuleExplanation> explainRules(const FuzzySystem& system,
                                          const std::vector<std::optional<double>>& inputs) {
    std::vector<RuleExplanation> explanations;
    explanations.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules) {
        RuleExplanation explanation;
        explanation.condition = degreeOf(rule.condition, system, inputs);
        explanation.firing = firingOf(rule, explanation.condition);
        addPropositions(explanation, rule.condition, system, inputs);
        explanations.push_back(std::move(explanation));
    }
    return explanations;
}

/// By the very steps of inference, with what lies between them kept: an explanation that computed in a way of
/// its own could disagree with the result. Sets are told rule by rule, as the user wrote them; collectSets()
/// may join some.
OutputExplanation explainOutput(const FuzzySystem& system, std::size_t output,
                                const std::vector<double>& firing) {
    OutputExplanation explanation;
    const FuzzyVariable& variable = system.outputs[output];
    for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
        for (const FuzzyProposition& conclusion : system.rules[rule].conclusions) {
            if (conclusion.variable != output) continue;
            if (const auto set = concludedSet(system, conclusion, firing[rule]))
                explanation.sets.push_back({rule, conclusion.term, firing[rule], outlineOf(*set, variable)});
        }
    OutputSets work = workingMemory(system);
    collectSets(work, system, output, firing);
    explanation.value = centreOfGravity(variable, system.norms.aggregation, work);
    explanation.aggregated = aggregatedOutline(variable, system.norms.aggregation, work);
    return explanation;
}

} // namespace esm

#include "core/fuzzy/rule_facts.h"

#include "core/fuzzy/normal_form.h"

#include <algorithm>

namespace esm {

namespace {

void collectInputs(std::set<std::size_t>& inputs, const FuzzyCondition& condition) {
    if (condition.kind == FuzzyCondition::Kind::Is) inputs.insert(condition.proposition.variable);
    for (const FuzzyCondition& part : condition.parts)
        collectInputs(inputs, part);
}

/// Each rule is compared with every other: what a comparison asks is worked out once for each rule, and not
/// once for each pair.
RuleFacts factsOf(const FuzzyRule& rule, const FuzzyNorms& norms, RuleReach& reach) {
    RuleFacts facts;
    facts.normalForm = normalForm(rule.condition, norms);
    collectInputs(facts.inputs, rule.condition);
    for (const auto [output, term] : rule.conclusions)
        facts.concluded[output].insert(term);
    facts.above = reach.where(rule.condition, RuleReach::Degree::AboveZero);
    facts.full = reach.where(rule.condition, RuleReach::Degree::Full);
    facts.canFire = rule.weight > 0 && !(facts.above && facts.above->empty());
    return facts;
}

/// Cells of the input for which a rule that asks for it may fire, whatever the other inputs are: the shadow
/// of the rule's boxes on this input. A rule covers everything where its boxes are not known, or where one of
/// them leaves the input open. What is reported as uncovered is therefore certain.
CellSet coveredCells(const std::vector<RuleFacts>& rules, std::size_t input, std::size_t count) {
    CellSet covered(count);
    CellSet whole = complementOf(covered, count);
    for (const RuleFacts& facts : rules) {
        if (!facts.canFire || facts.inputs.count(input) == 0) continue;
        if (!facts.above) return whole;
        for (const ValueBox& box : *facts.above) {
            const auto found =
                std::find_if(box.begin(), box.end(), [&](const auto& entry) { return entry.first == input; });
            if (found == box.end()) return whole;
            covered.unite(found->second);
        }
    }
    return covered;
}

} // namespace

std::vector<RuleFacts> factsOfRules(const FuzzySystem& system, RuleReach& reach) {
    std::vector<RuleFacts> facts;
    facts.reserve(system.rules.size());
    for (const FuzzyRule& rule : system.rules)
        facts.push_back(factsOf(rule, system.norms, reach));
    return facts;
}

std::vector<ValueRange> uncoveredRanges(const std::vector<RuleFacts>& rules, std::size_t input,
                                        const std::vector<ValueCell>& cells) {
    return rangesOf(cells, complementOf(coveredCells(rules, input, cells.size()), cells.size()));
}

} // namespace esm

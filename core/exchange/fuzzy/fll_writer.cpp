#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_identifiers.h"
#include "core/exchange/fuzzy/fuzzy_norm_names.h"
#include "core/exchange/fuzzy/fuzzy_text_writer.h"
#include "core/fuzzy/keywords.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

using ConditionKind = FuzzyCondition::Kind;

/// Words of its rules.
constexpr const char* fllReservedWords =
    "any extremely not seldom somewhat very if is and or then with none nan inf";

bool hasNotBeforeBrackets(const FuzzyCondition& condition) {
    if (condition.kind == ConditionKind::Not && condition.parts.front().kind != ConditionKind::Is)
        return true;
    return std::any_of(condition.parts.begin(), condition.parts.end(), hasNotBeforeBrackets);
}

/// By De Morgan's laws, with NOT before single propositions only.
FuzzyCondition withNotInside(const FuzzyCondition& condition, bool isNegated) {
    if (condition.kind == ConditionKind::Is) return isNegated ? negation(condition) : condition;
    if (condition.kind == ConditionKind::Not) return withNotInside(condition.parts.front(), !isNegated);
    FuzzyCondition result{{}, condition.kind, {}};
    if (isNegated)
        result.kind = condition.kind == ConditionKind::And ? ConditionKind::Or : ConditionKind::And;
    for (const FuzzyCondition& part : condition.parts)
        result.parts.push_back(withNotInside(part, isNegated));
    return result;
}

/// Keywords in small letters.
std::string fllRule(const FuzzySystem& system, const FuzzyRule& rule) {
    std::string text;
    for (const TextWord& word : textWords(ruleText(system, rule), {}, "()"))
        text += (text.empty() ? "" : " ") + (isKeyword(word.text) ? inSmallLetters(word.text) : word.text);
    return text;
}

class FllWriter {
public:
    explicit FllWriter(const FuzzySystem& original)
        : m_original(original), m_identified(withIdentifiers(original, fllReservedWords)) {}

    ExportedFuzzySystem write() {
        const FuzzySystem& system = m_identified.system;
        m_text.head(m_original, "Engine:");
        for (std::size_t i = 0; i < system.inputs.size(); ++i) {
            variable("InputVariable: ", m_original.inputs[i], system.inputs[i]);
            terms(m_original.inputs[i], system.inputs[i], "Trapezoid");
        }
        for (std::size_t i = 0; i < system.outputs.size(); ++i)
            output(m_original.outputs[i], system.outputs[i]);
        rules();
        return {m_text.takeText(), std::move(m_identified.warnings)};
    }

private:
    void variable(const std::string& kind, const FuzzyVariable& original, const FuzzyVariable& variable) {
        m_text.line(kind + variable.name + m_text.realName(original.name, variable.name));
        m_text.line("  enabled: true");
        m_text.line("  range: " + exactText(variable.minimum) + " " + exactText(variable.maximum) +
                    m_text.unit(variable));
        m_text.line("  lock-range: false");
    }

    void terms(const FuzzyVariable& original, const FuzzyVariable& variable, const std::string& shape) {
        for (std::size_t t = 0; t < variable.terms.size(); ++t) {
            const auto& [name, set] = variable.terms[t];
            std::string text = "  term: " + name + " " + shape + " " + exactText(set.a);
            if (shape != "Constant")
                for (const double corner : {set.b, set.c, set.d})
                    text += " " + exactText(corner);
            m_text.line(text + m_text.realName(original.terms[t].name, name));
        }
    }

    void output(const FuzzyVariable& original, const FuzzyVariable& output) {
        const bool hasPoints = hasPointsAlone(output);
        if (hasPoints)
            m_identified.warnings.push_back(
                "the terms of " + original.name +
                " are single points, of which fuzzylite takes the weighted average; it counts every rule");
        variable("OutputVariable: ", original, output);
        m_text.line(std::string("  aggregation: ") + foreignNames(m_original.norms.aggregation).fll);
        m_text.line(hasPoints ? "  defuzzifier: WeightedAverage TakagiSugeno"
                              : "  defuzzifier: Centroid 200");
        m_text.line("  default: nan");
        m_text.line("  lock-previous: false");
        terms(original, output, hasPoints ? "Constant" : "Trapezoid");
    }

    void rules() {
        const FuzzyNorms& norms = m_original.norms;
        m_text.line("RuleBlock: rules");
        m_text.line("  enabled: true");
        m_text.line(std::string("  conjunction: ") + foreignNames(norms.conjunction).fll);
        m_text.line(std::string("  disjunction: ") + foreignNames(norms.disjunction).fll);
        m_text.line(std::string("  implication: ") + foreignNames(norms.implication).fll);
        m_text.line("  activation: General");
        for (std::size_t i = 0; i < m_original.rules.size(); ++i)
            rule(i);
    }

    void rule(std::size_t index) {
        FuzzyRule rule = m_original.rules[index];
        if (hasNotBeforeBrackets(rule.condition)) {
            if (areDual(m_original.norms))
                rule.condition = withNotInside(rule.condition, false);
            else
                m_identified.warnings.push_back(
                    "rule " + std::to_string(index + 1) +
                    " has NOT before brackets, which fuzzylite does not read; with these norms it cannot be "
                    "said otherwise");
        }
        m_text.line("  rule: " + fllRule(m_identified.system, rule));
    }

    const FuzzySystem& m_original;
    IdentifiedSystem m_identified;
    FuzzyTextWriter m_text{{"#", "\n"}};
};

} // namespace

ExportedFuzzySystem toFll(const FuzzySystem& system) {
    return FllWriter(system).write();
}

} // namespace esm

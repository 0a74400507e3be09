#include "core/fuzzy/rule_row.h"

#include "core/fuzzy/keywords.h"
#include "core/fuzzy/rule_words.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

using Kind = FuzzyCondition::Kind;

/// Empty where the condition is no "input IS term" or "input IS NOT term".
std::optional<std::pair<std::size_t, RuleRow::Choice>> choiceOf(const FuzzyCondition& condition) {
    const bool isNegated = condition.kind == Kind::Not;
    const FuzzyCondition& inner = isNegated ? condition.parts.front() : condition;
    if (inner.kind != Kind::Is) return std::nullopt;
    return std::pair(inner.proposition.variable, RuleRow::Choice{inner.proposition.term, isNegated});
}

/// Whether cells can show the condition; then they do. A cell for each input and AND between them: one input
/// asked twice, OR, and brackets have no place there and stay text.
bool fillInputs(RuleRow& row, const FuzzyCondition& condition) {
    const std::vector<FuzzyCondition> alone{condition};
    for (const FuzzyCondition& part : condition.kind == Kind::And ? condition.parts : alone) {
        const auto choice = choiceOf(part);
        if (!choice || row.inputs[choice->first]) return false;
        row.inputs[choice->first] = choice->second;
    }
    return true;
}

bool fillOutputs(RuleRow& row, const std::vector<FuzzyProposition>& conclusions) {
    for (const auto [output, term] : conclusions) {
        if (row.outputs[output]) return false;
        row.outputs[output] = term;
    }
    return true;
}

/// "IF condition THEN conclusions WITH weight" in its parts.
struct RuleParts {
    std::string condition, conclusions, weight;
};

/// The text between two bytes, without blanks around it.
std::string partOf(const std::string& line, std::size_t begin, std::size_t end) {
    while (begin < end && static_cast<unsigned char>(line[begin]) <= ' ')
        ++begin;
    while (begin < end && static_cast<unsigned char>(line[end - 1]) <= ' ')
        --end;
    return line.substr(begin, end - begin);
}

/// By the keywords alone, without reading what stands between them: a part that no parser can read yet is
/// still kept as it was typed.
RuleParts partsOf(const std::string& line) {
    const std::vector<RuleWord> words = ruleWords(line);
    RuleParts parts;
    std::string* part = &parts.condition;
    std::size_t begin =
        isKeyword(words.front().text, "IF") ? words.front().text.size() + words.front().begin : 0;
    for (const RuleWord& word : words) {
        const bool isThen = isKeyword(word.text, "THEN"), isWith = isKeyword(word.text, "WITH");
        if (!isThen && !isWith && !word.text.empty()) continue;
        *part = partOf(line, begin, word.begin);
        part = isThen ? &parts.conclusions : &parts.weight;
        begin = word.begin + word.text.size();
    }
    return parts;
}

std::string lineOf(const RuleParts& parts) {
    std::string line = "IF";
    if (!parts.condition.empty()) line += " " + parts.condition;
    line += " THEN";
    if (!parts.conclusions.empty()) line += " " + parts.conclusions;
    if (!parts.weight.empty()) line += " WITH " + parts.weight;
    return line;
}

/// Whether what a line lacks can only be a condition or conclusions. A line without THEN, or with two, is no
/// rule with a gap but text that is still being typed.
bool mayBeUnfinished(const std::string& line) {
    int thens = 0, withs = 0;
    for (const RuleWord& word : ruleWords(line)) {
        thens += isKeyword(word.text, "THEN");
        withs += isKeyword(word.text, "WITH");
    }
    const RuleParts parts = partsOf(line);
    return thens == 1 && withs == (parts.weight.empty() ? 0 : 1) &&
           (parts.condition.empty() || parts.conclusions.empty());
}

/// What cells cannot show stays text, each side of the rule for itself: a condition in brackets leaves the
/// conclusions to their cells.
RuleRow filled(const FuzzySystem& system, const FuzzyRule& rule) {
    RuleRow row;
    row.inputs.resize(system.inputs.size());
    row.outputs.resize(system.outputs.size());
    row.weight = rule.weight;
    const RuleParts parts = partsOf(ruleText(system, rule));
    if (!fillInputs(row, rule.condition)) {
        row.inputs.assign(system.inputs.size(), std::nullopt);
        row.condition = parts.condition;
    }
    if (!fillOutputs(row, rule.conclusions)) {
        row.outputs.assign(system.outputs.size(), std::nullopt);
        row.conclusions = parts.conclusions;
    }
    return row;
}

std::string firstProposition(const std::vector<FuzzyVariable>& variables) {
    return variables.front().name + " IS " + variables.front().terms.front().name;
}

/// What is missing is put in, so that the parser for whole rules reads the rest, and taken away again: a
/// second grammar for unfinished rules could disagree with the first.
RuleRow unfinishedRow(const FuzzySystem& system, const std::string& line) {
    RuleParts parts = partsOf(line);
    const bool lacksCondition = parts.condition.empty(), lacksConclusions = parts.conclusions.empty();
    if (lacksCondition) parts.condition = firstProposition(system.inputs);
    if (lacksConclusions) parts.conclusions = firstProposition(system.outputs);
    RuleRow row = filled(system, parseRule(system, lineOf(parts)));
    if (lacksCondition) row.inputs.assign(system.inputs.size(), std::nullopt);
    if (lacksConclusions) row.outputs.assign(system.outputs.size(), std::nullopt);
    return row;
}

} // namespace

/// Three tries, from the most that can be shown to the least: a whole rule, one that lacks a side, a line of
/// text. The table and the text show the same rules, so that no line may get lost on the way into a row and
/// back.
RuleRow rowOf(const FuzzySystem& system, const std::string& line) {
    try {
        return filled(system, parseRule(system, line));
    } catch (const RuleError&) {
    }
    try {
        if (mayBeUnfinished(line)) return unfinishedRow(system, line);
    } catch (const RuleError&) {
    }
    RuleRow row;
    row.unread = line;
    return row;
}

std::string lineOf(const FuzzySystem& system, const RuleRow& row) {
    if (!row.unread.empty()) return row.unread;
    std::vector<std::string> conditions, conclusions;
    for (std::size_t i = 0; i < row.inputs.size(); ++i)
        if (const auto& choice = row.inputs[i]) {
            const FuzzyVariable& input = system.inputs[i];
            conditions.push_back(input.name + (choice->isNegated ? " IS NOT " : " IS ") +
                                 input.terms[choice->term].name);
        }
    for (std::size_t i = 0; i < row.outputs.size(); ++i)
        if (const auto& term = row.outputs[i])
            conclusions.push_back(system.outputs[i].name + " IS " + system.outputs[i].terms[*term].name);
    return lineOf(RuleParts{row.condition.empty() ? joined(conditions, " AND ") : row.condition,
                            row.conclusions.empty() ? joined(conclusions, " AND ") : row.conclusions,
                            row.weight == 1 ? std::string() : exactText(row.weight)});
}

} // namespace esm

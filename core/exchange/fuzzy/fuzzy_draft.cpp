#include "core/exchange/fuzzy/fuzzy_draft.h"

#include "core/exchange/fuzzy/fuzzy_identifiers.h"
#include "core/exchange/fuzzy/fuzzy_norm_names.h"
#include "core/fuzzy/keywords.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/numbers.h"
#include "core/support/text_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace esm {

namespace {

template<class Norm>
void settleAs(FuzzyDraft& draft, std::optional<Norm>& slot, const TextWord& word,
              const std::optional<ForeignNorm<Norm>>& named) {
    if (isKeyword(word.text, "NONE")) return;
    if (!named) {
        std::string known;
        for (const Norm norm : {static_cast<Norm>(0), static_cast<Norm>(1), static_cast<Norm>(2)})
            known += (known.empty() ? "" : ", ") + std::string(foreignNames(norm).fcl) + " (" +
                     foreignNames(norm).fll + ")";
        failAt(word.place, "the norm \"" + word.text + "\" cannot be taken; known are " + known);
    }
    if (named->isNear) draft.warn(word.place, word.text + " is taken as the bounded sum");
    if (slot && *slot != named->norm)
        draft.warn(word.place, word.text +
                                   " is not taken: a system has one norm for all its outputs and rules, " +
                                   "here " + wordOf(*slot));
    else
        slot = named->norm;
}

/// IEC 61131-7 has AND and OR go in pairs, so that one of them tells the other.
FuzzyNorms normsOf(const DraftNorms& draft) {
    FuzzyNorms norms;
    if (draft.conjunction) norms.conjunction = *draft.conjunction;
    if (draft.disjunction) norms.disjunction = *draft.disjunction;
    if (draft.conjunction && !draft.disjunction) norms.disjunction = dual(norms.conjunction);
    if (draft.disjunction && !draft.conjunction) norms.conjunction = dual(norms.disjunction);
    norms.implication = draft.implication.value_or(norms.implication);
    norms.aggregation = draft.aggregation.value_or(norms.aggregation);
    return norms;
}

std::pair<double, double> hullOf(const std::vector<DraftTerm>& terms) {
    std::pair<double, double> hull{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (const DraftTerm& term : terms) {
        hull.first = std::min(hull.first, term.shape.set.a);
        hull.second = std::max(hull.second, term.shape.set.d);
    }
    return hull;
}

FuzzyVariable variableFrom(FuzzyDraft& draft, const DraftVariable& source) {
    const bool hasRange =
        source.range && std::isfinite(source.range->first) && std::isfinite(source.range->second);
    const std::pair<double, double> range = hasRange ? *source.range : hullOf(source.terms);
    const TextWord& identifier = source.name.identifier;
    if (!hasRange && !source.terms.empty())
        draft.warn(identifier.place, identifier.text + " has no range; it is taken from its terms, " +
                                         roundedText(range.first) + " to " + roundedText(range.second));
    FuzzyVariable variable{identifier.text, range.first, range.second, {}, source.unit};
    for (const DraftTerm& term : source.terms) {
        Trapezoid set = term.shape.set;
        if (term.shape.opensLeft) set.a = set.b = std::min(set.b, range.first);
        if (term.shape.opensRight) set.c = set.d = std::max(set.c, range.second);
        variable.terms.push_back({term.name.identifier.text, set});
        if (source.meanOfPoints && !isSinglePoint(set))
            draft.warn(*source.meanOfPoints, "a mean of points is asked for, but " +
                                                 term.name.identifier.text +
                                                 " is none; the centre of gravity is taken");
    }
    return variable;
}

/// Of the part that the problem is of, else the end of the file, where something is missing.
TextPlace placeOfProblem(const FuzzyProblem& problem, const FuzzyDraft& draft) {
    if (!problem.part) return draft.end;
    const auto& list = problem.part->list == FuzzyPart::List::Inputs ? draft.inputs : draft.outputs;
    const DraftVariable& variable = list[problem.part->variable];
    const DraftName& name = problem.part->term ? variable.terms[*problem.part->term].name : variable.name;
    return name.identifier.place;
}

void checkDraft(const FuzzyDraft& draft, const FuzzySystem& system) {
    std::vector<std::string> problems;
    for (const FuzzyProblem& problem : problemsOf(system))
        problems.push_back(placed(placeOfProblem(problem, draft), problem.text));
    if (!problems.empty()) throw InvalidModel(problems);
}

void checkRuleCount(const FuzzyDraft& draft) {
    if (draft.rules.size() <= mostFuzzyRules) return;
    const DraftRule& rule = draft.rules[mostFuzzyRules];
    failAt(rule.words.empty() ? rule.end : rule.words.front().place, tooManyRules(draft.rules.size()));
}

template<class Part> void addPart(std::vector<Part>& list, Part part, const std::string& kind) {
    constexpr std::size_t most = 2000;
    if (list.size() == most)
        failAt(part.name.identifier.place, "there are more than " + std::to_string(most) + " " + kind);
    list.push_back(std::move(part));
}

/// A rule in one line, with the place in the file of each of its words.
struct RuleLine {
    std::string text;
    std::vector<std::size_t> columns;
};

/// IEC 61131-7 lists conclusions with commas.
RuleLine ruleLine(const DraftRule& rule) {
    RuleLine line;
    std::size_t column = 1;
    bool isConclusion = false;
    for (const TextWord& word : rule.words) {
        isConclusion = isConclusion || isKeyword(word.text, "THEN");
        const std::string text = isConclusion && word.text == "," ? "AND" : word.text;
        line.columns.push_back(column);
        line.text += text + " ";
        column += letterCount(text) + 1;
    }
    return line;
}

[[noreturn]] void failInRule(const DraftRule& rule, const RuleLine& line, const RuleError& error) {
    constexpr std::array hedges{"any", "extremely", "more", "seldom", "somewhat", "very"};
    std::string problem = error.problem();
    const RuleMistake& mistake = error.mistake();
    if (mistake.length == 0) failAt(rule.end, problem);
    const auto next = std::upper_bound(line.columns.begin(), line.columns.end(), mistake.column);
    const TextWord& word = rule.words[static_cast<std::size_t>(next - line.columns.begin()) - 1];
    if (std::find(hedges.begin(), hedges.end(), inSmallLetters(word.text)) != hedges.end())
        problem += "; hedges cannot be taken";
    failAt(word.place, problem);
}

FuzzyRule ruleFrom(const FuzzySystem& system, const DraftRule& rule) {
    const RuleLine line = ruleLine(rule);
    try {
        return parseRule(system, line.text);
    } catch (const RuleError& error) {
        failInRule(rule, line, error);
    }
}

/// In the order of the file.
std::vector<std::string> placedWarnings(FuzzyDraft& draft) {
    std::stable_sort(draft.warnings.begin(), draft.warnings.end(),
                     [](const auto& a, const auto& b) { return isBefore(a.first, b.first); });
    std::vector<std::string> warnings;
    for (const auto& [place, text] : draft.warnings)
        warnings.push_back(placed(place, text));
    return warnings;
}

std::string meantName(const DraftName& draft) {
    const std::string& identifier = draft.identifier.text;
    const bool isOurs = draft.name && nameProblem(*draft.name).empty();
    return isOurs && isIdentifierOf(identifier, *draft.name) ? *draft.name : identifier;
}

void giveRealNames(std::vector<FuzzyVariable>& variables, const std::vector<DraftVariable>& drafts) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
        variables[i].name = meantName(drafts[i].name);
        for (std::size_t t = 0; t < variables[i].terms.size(); ++t)
            variables[i].terms[t].name = meantName(drafts[i].terms[t].name);
    }
}

} // namespace

void readHead(FuzzyDraft& draft, const std::vector<TextRemark>& remarks, const TextPlace& firstCode) {
    for (const TextRemark& remark : remarks) {
        if (remark.place.line >= firstCode.line) break;
        if (const auto name = remarkFor("name", remark)) draft.name = name;
        if (const auto description = remarkFor("description", remark)) draft.description = *description;
        if (const auto note = remarkFor("note", remark)) draft.note = *note;
    }
}

DraftTerm draftTerm(FuzzyDraft& draft, DraftName name, const std::string& shape,
                    const std::vector<double>& numbers) {
    const TextPlace place = name.identifier.place;
    const std::string subject = "the term " + name.identifier.text + ": ";
    try {
        DraftTerm term{std::move(name), readShape(shape, numbers)};
        if (!term.shape.warning.empty()) draft.warn(place, subject + term.shape.warning);
        return term;
    } catch (const InvalidModel& error) {
        failAt(place, subject + error.what());
    }
}

void settleNorm(FuzzyDraft& draft, NormUse use, const TextWord& name) {
    DraftNorms& norms = draft.norms;
    switch (use) {
    case NormUse::Conjunction:
        return settleAs(draft, norms.conjunction, name, foreignTNorm(name.text));
    case NormUse::Disjunction:
        return settleAs(draft, norms.disjunction, name, foreignTConorm(name.text));
    case NormUse::Implication:
        return settleAs(draft, norms.implication, name, foreignTNorm(name.text));
    case NormUse::Aggregation:
        return settleAs(draft, norms.aggregation, name, foreignTConorm(name.text));
    }
}

void takeBlock(FuzzyDraft& draft, DraftRuleBlock block) {
    if (block.disabled) {
        draft.warn(*block.disabled, "the rule block is not enabled; its rules and norms are not taken");
        return;
    }
    for (const auto& [use, name] : block.norms)
        settleNorm(draft, use, name);
    draft.rules.insert(draft.rules.end(), std::make_move_iterator(block.rules.begin()),
                       std::make_move_iterator(block.rules.end()));
}

void addVariable(std::vector<DraftVariable>& list, DraftVariable variable) {
    addPart(list, std::move(variable), "variables");
}

void addTerm(DraftVariable& variable, DraftTerm term) {
    addPart(variable.terms, std::move(term), "terms");
}

std::optional<std::string> unitFrom(const TextRemark& remark) {
    std::optional<std::string> unit = remarkFor("unit", remark);
    if (unit && unit->size() > longestUnit)
        failAt(remark.place, "a unit may have " + std::to_string(longestUnit) + " bytes");
    return unit;
}

double numberAt(const TextWord& word) {
    const std::optional<double> number = wholeNumber<double>(word.text);
    if (!number) failAt(word.place, "expected a number, but found \"" + word.text + "\"");
    return *number;
}

ImportedFuzzySystem finished(FuzzyDraft draft) {
    checkRuleCount(draft);
    FuzzySystem system;
    system.name = draft.name.value_or("");
    system.description = draft.description;
    system.note = draft.note;
    for (const DraftVariable& input : draft.inputs)
        system.inputs.push_back(variableFrom(draft, input));
    for (const DraftVariable& output : draft.outputs)
        system.outputs.push_back(variableFrom(draft, output));
    system.norms = normsOf(draft.norms);
    checkDraft(draft, system); // rules can only be read against sound variables
    for (const DraftRule& rule : draft.rules)
        system.rules.push_back(ruleFrom(system, rule));
    if (system.rules.empty()) draft.warn(draft.end, "there are no rules");
    giveRealNames(system.inputs, draft.inputs);
    giveRealNames(system.outputs, draft.outputs);
    checkDraft(draft, system);
    return {std::move(system), placedWarnings(draft)};
}

} // namespace esm

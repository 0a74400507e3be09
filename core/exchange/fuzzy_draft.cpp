#include "core/exchange/fuzzy_draft.h"

#include "core/exchange/fuzzy_identifiers.h"
#include "core/exchange/fuzzy_norm_names.h"
#include "core/exchange/text_lines.h"
#include "core/fuzzy/keywords.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace esm {

namespace {

/// Places of what validate() speaks of, by its words for them ("inputs.zeal.terms.much").
using PlacesOfParts = std::map<std::string, TextPlace>;

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
                                   "here " + normName(*slot));
    else
        slot = named->norm;
}

/// IEC 61131-7 has AND and OR go in pairs, so that one of them tells the other.
FuzzyNorms normsOf(const DraftNorms& draft) {
    FuzzyNorms norms;
    if (draft.conjunction) norms.conjunction = *draft.conjunction;
    if (draft.disjunction) norms.disjunction = *draft.disjunction;
    if (draft.conjunction && !draft.disjunction) norms.disjunction = static_cast<TConorm>(norms.conjunction);
    if (draft.disjunction && !draft.conjunction) norms.conjunction = static_cast<TNorm>(norms.disjunction);
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
                                         numberText(range.first) + " to " + numberText(range.second));
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

void addPlaces(PlacesOfParts& places, const std::string& list, const std::vector<DraftVariable>& drafts,
               const std::vector<FuzzyVariable>& variables) {
    for (std::size_t i = 0; i < variables.size(); ++i) {
        const std::string place = list + "." + variables[i].name;
        places[place] = drafts[i].name.identifier.place;
        for (std::size_t t = 0; t < variables[i].terms.size(); ++t)
            places[place + ".terms." + variables[i].terms[t].name] = drafts[i].terms[t].name.identifier.place;
    }
}

/// Of the smallest part that the problem speaks of, else the end of the file, where something is missing.
TextPlace placeOfProblem(const PlacesOfParts& places, const std::string& problem, const TextPlace& end) {
    std::string part = problem.substr(0, problem.find(": "));
    for (;;) {
        const auto found = places.find(part);
        if (found != places.end()) return found->second;
        const std::size_t dot = part.rfind('.');
        if (dot == part.npos) return end;
        part.erase(dot);
    }
}

void checkDraft(const FuzzyDraft& draft, const FuzzySystem& system) {
    PlacesOfParts places;
    addPlaces(places, "inputs", draft.inputs, system.inputs);
    addPlaces(places, "outputs", draft.outputs, system.outputs);
    std::vector<std::string> problems = validate(system);
    for (std::string& problem : problems)
        problem = placed(placeOfProblem(places, problem, draft.end), problem);
    if (!problems.empty()) throw InvalidModel(problems);
}

/// As many as an object of JSON may have members.
void checkCounts(const FuzzyDraft& draft) {
    constexpr std::size_t most = 2000;
    for (const auto* variables : {&draft.inputs, &draft.outputs}) {
        if (variables->size() > most)
            failAt((*variables)[most].name.identifier.place,
                   "there are more than " + std::to_string(most) + " variables");
        for (const DraftVariable& variable : *variables)
            if (variable.terms.size() > most)
                failAt(variable.terms[most].name.identifier.place,
                       "there are more than " + std::to_string(most) + " terms");
    }
    if (draft.rules.size() > mostFuzzyRules) {
        const DraftRule& rule = draft.rules[mostFuzzyRules];
        failAt(rule.words.empty() ? rule.end : rule.words.front().place, tooManyRules(draft.rules.size()));
    }
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
    const std::string message = error.what();
    std::string problem = message.substr(message.find(": ") + 2);
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
    return draft.name && isIdentifierOf(identifier, *draft.name) ? *draft.name : identifier;
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

void settleNorm(FuzzyDraft& draft, std::optional<TNorm>& norm, const TextWord& name) {
    settleAs(draft, norm, name, foreignTNorm(name.text));
}

void settleNorm(FuzzyDraft& draft, std::optional<TConorm>& norm, const TextWord& name) {
    settleAs(draft, norm, name, foreignTConorm(name.text));
}

double numberAt(const TextWord& word) {
    const std::optional<double> number = wholeNumber<double>(word.text);
    if (!number) failAt(word.place, "expected a number, but found \"" + word.text + "\"");
    return *number;
}

ImportedFuzzySystem finished(FuzzyDraft draft) {
    checkCounts(draft);
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

#include "core/fuzzy/system_warnings.h"

#include "core/fuzzy/empty_outputs.h"
#include "core/support/joined.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace esm {

namespace {

using WarningKind = SystemWarning::Kind;
using ValueBoxes = std::vector<ValueBox>;

/// Comparisons of rules and of their boxes. The most rules there may be, 2000, make two million pairs: all of
/// them are looked at, with one box each on the mean.
constexpr std::size_t mostPairWork = 4'000'000;

/// "Rule 3", "Rules 3, 5 and 8", "Rules 3, 5, 8, 9, 12, 15 and 40 more".
std::string rulesInWords(const std::vector<std::size_t>& rules) {
    constexpr std::size_t mostNamed = 6;
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < std::min(rules.size(), mostNamed); ++i)
        numbers.push_back(std::to_string(rules[i] + 1));
    if (rules.size() == 1) return "Rule " + numbers.front();
    if (rules.size() > mostNamed)
        return "Rules " + joined(numbers) + " and " + std::to_string(rules.size() - mostNamed) + " more";
    const std::string last = numbers.back();
    numbers.pop_back();
    return "Rules " + joined(numbers) + " and " + last;
}

std::string termsInWords(const FuzzyVariable& variable, const TermSet& terms) {
    std::vector<std::string> names;
    names.reserve(terms.size());
    for (const std::size_t term : terms)
        names.push_back(variable.terms[term].name);
    return joined(names, " and ");
}

/// Everything is found from the corners of the terms (rule_reach.cpp): nothing is sampled, so that a gap as
/// narrow as one value is found. Each kind of warning is a pass of its own over the rules' facts. Only
/// contradictions need pairs of rules; all else is linear in them, or sorts them. What would take too long is
/// left out, and said to be.
class WarningFinder {
public:
    explicit WarningFinder(const FuzzySystem& system)
        : m_system(system), m_reach(system), m_facts(factsOfRules(system, m_reach)) {}

    std::vector<SystemWarning> all() {
        findContradictions();
        findRulesThatNeverFire();
        findDuplicates();
        findEmptyOutputs();
        for (std::size_t input = 0; input < m_system.inputs.size(); ++input)
            findUncovered(input);
        tellEmptyOutputs();
        findUnused(m_system.inputs, askedTerms(), "No rule asks for ", "No rule asks whether ");
        findUnused(m_system.outputs, concludedTerms(), "No rule concludes ", "No rule says that ");
        if (m_hasMoreContradictions)
            add(WarningKind::NotChecked, "There are more contradictions than the " +
                                             std::to_string(mostContradictions) + " that are listed.");
        if (m_isIncomplete || anyRule([](const RuleFacts& facts) { return !facts.above; }))
            add(WarningKind::NotChecked,
                "There are too many rules, or too intricate ones, to check all of them.");
        return std::move(m_warnings);
    }

private:
    void add(WarningKind kind, const std::string& text, std::vector<std::size_t> rules = {}) {
        m_warnings.push_back({kind, text, std::move(rules)});
    }

    /// Contradictions come first, so that the list holds them alone while they are looked for.
    void addContradiction(const std::string& text, std::vector<std::size_t> rules) {
        m_hasMoreContradictions = m_warnings.size() == mostContradictions;
        if (!m_hasMoreContradictions) add(WarningKind::Contradiction, text, std::move(rules));
    }

    void findContradictions() {
        for (std::size_t rule = 0; rule < m_facts.size(); ++rule)
            findContradictionWithin(rule);
        for (std::size_t one = 0; one < m_facts.size(); ++one)
            for (std::size_t other = one + 1; other < m_facts.size(); ++other) {
                if (m_hasMoreContradictions) return;
                m_isIncomplete = m_isIncomplete || m_work > mostPairWork;
                if (m_work > mostPairWork) return;
                ++m_work;
                compare(one, other);
            }
    }

    void findContradictionWithin(std::size_t rule) {
        for (const auto& [output, terms] : m_facts[rule].concluded)
            if (terms.size() > 1) {
                const FuzzyVariable& variable = m_system.outputs[output];
                addContradiction(rulesInWords({rule}) + " contradicts itself: it says that " + variable.name +
                                     " is " + termsInWords(variable, terms) + " at once.",
                                 {rule});
            }
    }

    void compare(std::size_t one, std::size_t other) {
        const RuleFacts &a = m_facts[one], &b = m_facts[other];
        if (!a.canFire || !b.canFire) return;
        for (const auto& [output, terms] : a.concluded) {
            const auto found = b.concluded.find(output);
            if (found == b.concluded.end() || found->second == terms) continue;
            const std::optional<std::string> when = whenBothHold(a, b);
            if (!when) return;
            const FuzzyVariable& variable = m_system.outputs[output];
            addContradiction(rulesInWords({one, other}) + " contradict each other" + *when + ": " +
                                 variable.name + " is " + termsInWords(variable, terms) + " by rule " +
                                 std::to_string(one + 1) + " and " + termsInWords(variable, found->second) +
                                 " by rule " + std::to_string(other + 1) + ".",
                             {one, other});
        }
    }

    /// In words, an example of it; empty where the rules are not about the same case. Two rules that hold
    /// partly at the same place and conclude different terms are how fuzzy systems pass from one to the
    /// other; a contradiction is only where both hold fully. Rules about different inputs are each evidence
    /// of its own and may disagree, unless one is a special case of the other: there the general rule says
    /// what the special one denies.
    std::optional<std::string> whenBothHold(const RuleFacts& a, const RuleFacts& b) {
        if (a.normalForm == b.normalForm) return " on the same condition";
        const bool askTheSame = a.inputs == b.inputs;
        const bool mayImply =
            std::includes(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end()) ||
            std::includes(b.inputs.begin(), b.inputs.end(), a.inputs.begin(), a.inputs.end());
        if (!mayImply) return std::nullopt;
        if (!a.full || !b.full) {
            m_isIncomplete = true;
            return std::nullopt;
        }
        m_work += a.full->size() * b.full->size();
        const std::optional<ValueBox> common = anyCommon(*a.full, *b.full);
        if (!common) return std::nullopt;
        if (!askTheSame && !areWithin(*a.full, *b.full) && !areWithin(*b.full, *a.full)) return std::nullopt;
        return " where " + example(*common);
    }

    static std::optional<ValueBox> anyCommon(const ValueBoxes& one, const ValueBoxes& other) {
        for (const ValueBox& a : one)
            for (const ValueBox& b : other)
                if (meet(a, b)) return commonPart(a, b);
        return std::nullopt;
    }

    /// Each inner box within one outer box. A box that only several outer ones cover together is not
    /// recognised: a contradiction may be missed, none is invented.
    static bool areWithin(const ValueBoxes& inner, const ValueBoxes& outer) {
        return std::all_of(inner.begin(), inner.end(), [&](const ValueBox& box) {
            return std::any_of(outer.begin(), outer.end(),
                               [&](const ValueBox& around) { return isWithin(box, around); });
        });
    }

    std::string example(const ValueBox& box) const {
        std::vector<std::string> parts;
        for (const auto& [input, cells] : box)
            parts.push_back(
                m_system.inputs[input].name + " is " +
                inWords(rangesOf(m_reach.cells(input), cells).front(), m_system.inputs[input].unit));
        return parts.empty() ? "both hold" : joined(parts, " and ");
    }

    /// In two groups, as what to do about them differs: a condition is to be mended, a weight was set.
    void findRulesThatNeverFire() {
        std::vector<std::size_t> weightless, impossible;
        for (std::size_t rule = 0; rule < m_facts.size(); ++rule)
            if (!m_facts[rule].canFire)
                (m_system.rules[rule].weight > 0 ? impossible : weightless).push_back(rule);
        const auto tell = [&](const std::vector<std::size_t>& rules, const char* one, const char* many) {
            if (rules.empty()) return;
            const std::string verb = rules.size() == 1 ? " never fires: " : " never fire: ";
            add(WarningKind::NeverFires, rulesInWords(rules) + verb + (rules.size() == 1 ? one : many),
                rules);
        };
        tell(impossible, "its condition cannot hold.", "their conditions cannot hold.");
        tell(weightless, "its weight is 0.", "their weights are 0.");
    }

    /// Rules that say the same have the same key, normal form and conclusions, which brings them together in
    /// one pass. Groups are told in the order of their first rules.
    void findDuplicates() {
        std::map<std::pair<std::string, std::map<std::size_t, TermSet>>, std::vector<std::size_t>> saying;
        for (std::size_t rule = 0; rule < m_facts.size(); ++rule)
            saying[{m_facts[rule].normalForm, m_facts[rule].concluded}].push_back(rule);
        std::vector<std::vector<std::size_t>> groups;
        for (auto& [said, rules] : saying)
            if (rules.size() > 1) groups.push_back(std::move(rules));
        std::sort(groups.begin(), groups.end());
        for (const auto& rules : groups) {
            const double weight = m_system.rules[rules.front()].weight;
            const bool weighAlike = std::all_of(rules.begin(), rules.end(), [&](std::size_t rule) {
                return m_system.rules[rule].weight == weight;
            });
            add(WarningKind::Duplicate,
                rulesInWords(rules) +
                    (weighAlike ? " say the same." : " say the same with different weights."),
                rules);
        }
    }

    /// Values that belong to no term are uncovered as well; that is the cause and said instead, once.
    void findUncovered(std::size_t input) {
        const FuzzyVariable& variable = m_system.inputs[input];
        const std::vector<ValueCell>& cells = m_reach.cells(input);
        const bool isAskedFor =
            anyRule([&](const RuleFacts& facts) { return facts.inputs.count(input) > 0; });
        const bool othersFire =
            anyRule([&](const RuleFacts& facts) { return facts.canFire && facts.inputs.count(input) == 0; });
        std::vector<ValueRange> uncovered;
        if (isAskedFor) uncovered = uncoveredRanges(m_facts, input, cells);
        for (const ValueRange& gap : partitionGaps(variable)) {
            const auto same = std::find_if(uncovered.begin(), uncovered.end(), [&](const ValueRange& range) {
                return range.from == gap.from && range.to == gap.to;
            });
            const bool isUncovered = same != uncovered.end();
            if (isUncovered) uncovered.erase(same);
            add(WarningKind::PartitionGap, "Where " + variable.name + " is " + inWords(gap, variable.unit) +
                                               " it belongs to no term" +
                                               (!isUncovered ? "."
                                                : othersFire ? ", and no rule that asks for it fires."
                                                             : ", and no rule fires."));
        }
        for (const ValueRange& range : uncovered) {
            const std::string is = " is " + inWords(range, variable.unit);
            if (!othersFire)
                add(WarningKind::UncoveredRange, "No rule fires where " + variable.name + is + ".");
            else if (!isEmptyPlace(" where " + variable.name + is)) // else told by what it leaves empty
                add(WarningKind::UncoveredRange,
                    "No rule that asks for " + variable.name + " fires where it" + is + ".");
        }
    }

    /// What is empty of several outputs at once is told once; where no rule fires at all because of one
    /// input, findUncovered() tells it.
    void findEmptyOutputs() {
        const auto concluded = concludedTerms();
        const auto wanted = std::count_if(concluded.begin(), concluded.end(),
                                          [](const TermSet& terms) { return !terms.empty(); });
        const std::vector<OutputCases> found = casesOfOutputs(concluded);
        const bool isAll = static_cast<std::ptrdiff_t>(found.size()) == wanted;
        const std::vector<CellSet> told = isAll ? decidedForAll(found) : std::vector<CellSet>();
        for (const auto& [output, cases] : found)
            for (const std::string& place : placesOf(cases, told))
                placeOf(place).outputs.push_back(m_system.outputs[output].name);
    }

    void tellEmptyOutputs() {
        for (const auto& [place, outputs] : m_emptyPlaces)
            add(WarningKind::EmptyOutput, "No rule fires for " + joined(outputs, " and ") + place + ".");
    }

    using OutputCases = std::pair<std::size_t, EmptyCases>;

    /// Of each output that some rule concludes.
    std::vector<OutputCases> casesOfOutputs(const std::vector<TermSet>& concluded) {
        std::vector<OutputCases> found;
        std::size_t work = 0;
        for (std::size_t output = 0; output < m_system.outputs.size(); ++output) {
            if (concluded[output].empty()) continue;
            if (auto cases = emptyCases(m_facts, output, m_reach, work))
                found.emplace_back(output, std::move(*cases));
            else
                m_isIncomplete = true;
        }
        return found;
    }

    struct EmptyPlace {
        std::string where;
        std::vector<std::string> outputs;
    };

    EmptyPlace& placeOf(const std::string& where) {
        const auto same = std::find_if(m_emptyPlaces.begin(), m_emptyPlaces.end(),
                                       [&](const EmptyPlace& place) { return place.where == where; });
        return same != m_emptyPlaces.end() ? *same : m_emptyPlaces.emplace_back(EmptyPlace{where, {}});
    }

    bool isEmptyPlace(const std::string& where) const {
        return std::any_of(m_emptyPlaces.begin(), m_emptyPlaces.end(),
                           [&](const EmptyPlace& place) { return place.where == where; });
    }

    /// By input, what leaves each of the outputs empty whatever the other inputs are.
    std::vector<CellSet> decidedForAll(const std::vector<std::pair<std::size_t, EmptyCases>>& outputs) const {
        std::vector<CellSet> cells;
        if (!outputs.empty()) cells = outputs.front().second.decided;
        for (std::size_t input = 0; input < cells.size(); ++input)
            for (const auto& [output, cases] : outputs)
                cells[input].intersect(cases.decided[input]);
        return cells;
    }

    /// " where age is from 3 to 4 and zeal is above 0.5, up to 1", for each of the cases.
    std::vector<std::string> placesOf(const EmptyCases& cases, const std::vector<CellSet>& told) const {
        std::vector<std::string> places;
        for (std::size_t input = 0; input < cases.decided.size(); ++input) {
            CellSet cells = cases.decided[input];
            if (!told.empty()) cells.intersect(complementOf(told[input], m_reach.cells(input).size()));
            if (!cells.isEmpty()) places.push_back(" where " + rangesInWords({{input, cells}}));
        }
        const std::size_t named = std::min(cases.combined.size(), mostEmptyCombinations);
        for (std::size_t i = 0; i < named; ++i)
            places.push_back(cases.combined[i].empty() ? ", whatever the inputs are"
                                                       : " where " + rangesInWords(cases.combined[i]));
        if (const std::size_t more = cases.combined.size() - named)
            places.push_back(" in " + std::to_string(more) + " more combination" + (more > 1 ? "s" : "") +
                             " of inputs");
        return places;
    }

    std::string rangesInWords(const ValueBox& box) const {
        std::vector<std::string> inputs;
        for (const auto& [input, cells] : box) {
            const FuzzyVariable& variable = m_system.inputs[input];
            std::vector<std::string> ranges;
            for (const ValueRange& range : rangesOf(m_reach.cells(input), cells))
                ranges.push_back(inWords(range, variable.unit));
            inputs.push_back(variable.name + " is " + joined(ranges, " or "));
        }
        return joined(inputs, " and ");
    }

    template<class Holds> bool anyRule(const Holds& holds) const {
        return std::any_of(m_facts.begin(), m_facts.end(), holds);
    }

    std::vector<TermSet> askedTerms() const {
        std::vector<TermSet> asked(m_system.inputs.size());
        for (const FuzzyRule& rule : m_system.rules)
            collectTerms(asked, rule.condition);
        return asked;
    }

    static void collectTerms(std::vector<TermSet>& asked, const FuzzyCondition& condition) {
        const auto [input, term] = condition.proposition;
        if (condition.kind == FuzzyCondition::Kind::Is) asked[input].insert(term);
        for (const FuzzyCondition& part : condition.parts)
            collectTerms(asked, part);
    }

    std::vector<TermSet> concludedTerms() const {
        std::vector<TermSet> concluded(m_system.outputs.size());
        for (const RuleFacts& facts : m_facts)
            for (const auto& [output, terms] : facts.concluded)
                concluded[output].insert(terms.begin(), terms.end());
        return concluded;
    }

    /// Where a variable is not spoken of at all, that is said once, and not of each of its terms.
    void findUnused(const std::vector<FuzzyVariable>& variables, const std::vector<TermSet>& used,
                    const std::string& ofVariable, const std::string& ofTerms) {
        for (std::size_t i = 0; i < variables.size(); ++i) {
            const FuzzyVariable& variable = variables[i];
            if (used[i].empty()) {
                add(WarningKind::UnusedVariable, ofVariable + variable.name + ".");
                continue;
            }
            std::vector<std::string> idle;
            for (std::size_t term = 0; term < variable.terms.size(); ++term)
                if (used[i].count(term) == 0) idle.push_back(variable.terms[term].name);
            if (!idle.empty())
                add(WarningKind::UnusedTerm, ofTerms + variable.name + " is " + joined(idle, " or ") + ".");
        }
    }

    const FuzzySystem& m_system;
    RuleReach m_reach;
    std::vector<RuleFacts> m_facts;
    std::vector<SystemWarning> m_warnings;
    std::vector<EmptyPlace> m_emptyPlaces; ///< values of inputs, and the outputs that they leave empty
    std::size_t m_work = 0;
    bool m_isIncomplete = false, m_hasMoreContradictions = false;
};

} // namespace

std::vector<SystemWarning> systemWarnings(const FuzzySystem& system) {
    if (system.rules.empty()) return {{WarningKind::NoRule, "There is no rule: no output gets a value.", {}}};
    return WarningFinder(system).all();
}

} // namespace esm

#include "core/fuzzy/rule_text.h"

#include "core/fuzzy/keywords.h"
#include "core/fuzzy/rule_words.h"
#include "core/support/joined.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace esm {

namespace {

using Kind = FuzzyCondition::Kind;

/// What would have fitted at a place.
struct Expectation {
    std::string inWords;
    std::vector<std::string> alternatives;
};

/// `"AND", "OR", "THEN"` as "AND, OR or THEN"; brackets in quotes.
std::string oneOf(std::vector<std::string> words) {
    for (std::string& word : words)
        if (isBracket(word.front())) word = '"' + word + '"';
    const std::string last = words.back();
    words.pop_back();
    return words.empty() ? last : joined(words) + " or " + last;
}

template<class List> Expectation nameOf(const std::string& kind, const List& list) {
    Expectation expectation{"the name of " + kind + " (" + joinedNames(list) + ")", {}};
    for (const auto& entry : list)
        expectation.alternatives.push_back(entry.name);
    return expectation;
}

Expectation wordsOr(std::vector<std::string> words, Expectation other) {
    std::vector<std::string> either = words;
    either.push_back(other.inWords);
    other.inWords = oneOf(either);
    other.alternatives.insert(other.alternatives.end(), std::make_move_iterator(words.begin()),
                              std::make_move_iterator(words.end()));
    return other;
}

/// Recursive descent: disjunction → conjunction → factor → NOT factor | ( disjunction ) | proposition. A
/// function for each of these is the grammar itself, written out. It sees one word ahead, never goes back,
/// and knows at the first word that does not fit what would have fitted there: that is the message to the
/// user, and what an editor offers (wordsThatFit()).
///
/// A word is read as what is expected in its place and looked up in the list that may stand there, so that a
/// term may be called like a variable. Lists have a few names; time goes with the words times those.
class RuleParser {
public:
    RuleParser(const FuzzySystem& system, const std::string& text)
        : m_system(system), m_words(ruleWords(text)) {}

    FuzzyRule parse() {
        FuzzyRule rule;
        expect({"IF"});
        const std::size_t beginning = m_next;
        rule.condition = alternatives(1);
        expect({"AND", "OR", "THEN"});
        if (isDeeperThan(deepestCondition, rule.condition)) failAsTooDeep(m_words[beginning]);
        do
            rule.conclusions.push_back(conclusion());
        while (accept("AND"));
        const bool isWeighted = accept("WITH");
        if (isWeighted) rule.weight = weight();
        const Expectation end{"the end of the rule", {}};
        if (!word().text.empty()) fail(isWeighted ? end : wordsOr({"AND", "WITH"}, end));
        return rule;
    }

private:
    const RuleWord& word() const { return m_words[m_next]; }

    bool accept(const char* keyword) {
        if (!isKeyword(word().text, keyword)) return false;
        ++m_next;
        return true;
    }

    /// The last one; those before it could have stood there as well.
    void expect(const std::vector<std::string>& words) {
        if (!accept(words.back().c_str())) fail({oneOf(words), words});
    }

    FuzzyCondition alternatives(int level) {
        return chain(Kind::Or, "OR", [&] { return chain(Kind::And, "AND", [&] { return factor(level); }); });
    }

    /// Parts joined by the keyword; a part in brackets that is joined by the same needs no level of its own.
    template<class ReadPart> FuzzyCondition chain(Kind kind, const char* keyword, const ReadPart& readPart) {
        std::vector<FuzzyCondition> parts;
        do {
            FuzzyCondition part = readPart();
            if (part.kind == kind)
                parts.insert(parts.end(), std::make_move_iterator(part.parts.begin()),
                             std::make_move_iterator(part.parts.end()));
            else
                parts.push_back(std::move(part));
        } while (accept(keyword));
        if (parts.size() == 1) return std::move(parts.front());
        return {{}, kind, std::move(parts)};
    }

    /// The level is bounded on the way down and not when the rule is read: a text of a million brackets would
    /// else overflow the stack first.
    FuzzyCondition factor(int level) {
        if (level > deepestCondition) failAsTooDeep(word());
        if (accept("NOT")) return negation(factor(level + 1));
        if (!accept("(")) return inputProposition();
        FuzzyCondition condition = alternatives(level + 1);
        expect({"AND", "OR", ")"});
        return condition;
    }

    FuzzyCondition inputProposition() {
        const std::vector<FuzzyVariable>& inputs = m_system.inputs;
        const std::size_t variable = indexOf(inputs, [&] {
            return wordsOr({"NOT", "("}, nameOf("an input", inputs));
        });
        expect({"IS"});
        const FuzzyVariable& input = inputs[variable];
        const bool isNegated = accept("NOT");
        const std::size_t term =
            indexOf(input.terms, [&] { return isNegated ? termOf(input) : wordsOr({"NOT"}, termOf(input)); });
        const FuzzyCondition condition{{variable, term}};
        return isNegated ? negation(condition) : condition;
    }

    FuzzyProposition conclusion() {
        const std::vector<FuzzyVariable>& outputs = m_system.outputs;
        const std::size_t variable = indexOf(outputs, [&] { return nameOf("an output", outputs); });
        expect({"IS"});
        const FuzzyVariable& output = outputs[variable];
        return {variable, indexOf(output.terms, [&] { return termOf(output); })};
    }

    static Expectation termOf(const FuzzyVariable& variable) {
        return nameOf("a term of " + variable.name, variable.terms);
    }

    /// Of the word in the list; what was expected is put together only where it is not there.
    template<class Named, class Expected>
    std::size_t indexOf(const std::vector<Named>& list, const Expected& expected) {
        const auto found = std::find_if(list.begin(), list.end(),
                                        [&](const Named& entry) { return entry.name == word().text; });
        if (found == list.end()) fail(expected());
        ++m_next;
        return static_cast<std::size_t>(found - list.begin());
    }

    /// By from_chars, which knows no other decimal point than the one of rules, whatever the machine's
    /// language.
    double weight() {
        const std::string& text = word().text;
        double value = -1;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool isWeight =
            error == std::errc() && end == text.data() + text.size() && value >= 0 && value <= 1;
        if (!isWeight) fail({"a weight from 0 to 1", {}});
        ++m_next;
        return value;
    }

    [[noreturn]] void fail(const Expectation& expectation) const {
        const std::string found =
            word().text.empty() ? "but the rule ends" : "but found \"" + word().text + "\"";
        throw RuleError("expected " + expectation.inWords + ", " + found,
                        {word().column, word().length, expectation.alternatives});
    }

    [[noreturn]] static void failAsTooDeep(const RuleWord& word) {
        throw RuleError("brackets and NOT are nested deeper than " + std::to_string(deepestCondition),
                        {word.column, word.length, {}});
    }

    const FuzzySystem& m_system;
    std::vector<RuleWord> m_words;
    std::size_t m_next = 0;
};

std::string propositionText(const std::vector<FuzzyVariable>& variables, const FuzzyProposition& proposition,
                            const char* is = " IS ") {
    const FuzzyVariable& variable = variables.at(proposition.variable);
    return variable.name + is + variable.terms.at(proposition.term).name;
}

/// How tightly a condition holds together: the looser of two needs brackets within the other. Text is written
/// by these numbers and read by the nesting of the parser's functions; both say that NOT binds tighter than
/// AND, and AND than OR.
int tightness(Kind kind) {
    switch (kind) {
    case Kind::Or:
        return 0;
    case Kind::And:
        return 1;
    case Kind::Not:
        return 2;
    default:
        return 3;
    }
}

std::string conditionText(const std::vector<FuzzyVariable>& inputs, const FuzzyCondition& condition);

/// The fewest brackets with which the text is read back as the same condition.
std::string partText(const std::vector<FuzzyVariable>& inputs, const FuzzyCondition& part, Kind whole) {
    const std::string text = conditionText(inputs, part);
    return tightness(part.kind) < tightness(whole) ? "(" + text + ")" : text;
}

std::string conditionText(const std::vector<FuzzyVariable>& inputs, const FuzzyCondition& condition) {
    if (condition.kind == Kind::Is) return propositionText(inputs, condition.proposition);
    if (condition.kind == Kind::Not) {
        const FuzzyCondition& part = condition.parts.at(0);
        return part.kind == Kind::Is ? propositionText(inputs, part.proposition, " IS NOT ")
                                     : "NOT " + partText(inputs, part, Kind::Not);
    }
    std::vector<std::string> parts;
    for (const FuzzyCondition& part : condition.parts)
        parts.push_back(partText(inputs, part, condition.kind));
    return joined(parts, condition.kind == Kind::And ? " AND " : " OR ");
}

} // namespace

/// Letters from A to Z alone, and not as the machine's language has them: in Turkish the small letter of I is
/// another one.
bool isKeyword(const std::string& word, const char* keyword) {
    const std::string expected(keyword);
    return word.size() == expected.size() &&
           std::equal(expected.begin(), expected.end(), word.begin(), [](char wanted, char given) {
               return given == wanted || (wanted >= 'A' && given == wanted - 'A' + 'a');
           });
}

bool isKeyword(const std::string& word) {
    return std::any_of(ruleKeywords.begin(), ruleKeywords.end(),
                       [&](const char* keyword) { return isKeyword(word, keyword); });
}

std::string ruleText(const FuzzySystem& system, const FuzzyRule& rule) {
    std::vector<std::string> conclusions;
    for (const FuzzyProposition& conclusion : rule.conclusions)
        conclusions.push_back(propositionText(system.outputs, conclusion));
    std::string text =
        "IF " + conditionText(system.inputs, rule.condition) + " THEN " + joined(conclusions, " AND ");
    if (rule.weight != 1) text += " WITH " + exactText(rule.weight);
    return text;
}

FuzzyRule parseRule(const FuzzySystem& system, const std::string& text) {
    return RuleParser(system, text).parse();
}

} // namespace esm

#include "core/fuzzy/fuzzy_system.h"
#include "core/fuzzy/keywords.h"
#include "core/support/errors.h"
#include "core/support/joined.h"

#include <algorithm>

namespace esm {

namespace {

struct Word {
    std::string text;
    std::size_t column; ///< of its first letter, from 1
};

std::vector<Word> words(const std::string& text) {
    std::vector<Word> list;
    std::size_t column = 0;
    bool inWord = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool startsLetter = (byte & 0xC0) != 0x80; // the other bytes of a UTF-8 letter are no column
        if (startsLetter) ++column;
        if (byte <= ' ') {
            inWord = false;
            continue;
        }
        if (!inWord) list.push_back({"", column});
        inWord = true;
        list.back().text += c;
    }
    list.push_back({"", column + 1});
    return list;
}

class RuleParser {
public:
    RuleParser(const FuzzySystem& system, const std::string& text) : m_system(system), m_words(words(text)) {}

    FuzzyRule parse() {
        FuzzyRule rule;
        expect("IF");
        do
            rule.conditions.push_back(proposition(m_system.inputs, "an input"));
        while (accept("AND"));
        if (!accept("THEN")) fail("expected AND or THEN");
        do
            rule.conclusions.push_back(proposition(m_system.outputs, "an output"));
        while (accept("AND"));
        if (!word().text.empty()) fail("expected AND or the end of the rule");
        return rule;
    }

private:
    const Word& word() const { return m_words[m_next]; }

    bool accept(const char* keyword) {
        if (!isKeyword(word().text, keyword)) return false;
        ++m_next;
        return true;
    }

    void expect(const char* keyword) {
        if (!accept(keyword)) fail(std::string("expected ") + keyword);
    }

    FuzzyProposition proposition(const std::vector<FuzzyVariable>& variables, const std::string& kind) {
        FuzzyProposition result;
        result.variable = indexOf(variables, kind);
        expect("IS");
        result.term =
            indexOf(variables[result.variable].terms, "a term of " + variables[result.variable].name);
        return result;
    }

    template<class Named> std::size_t indexOf(const std::vector<Named>& list, const std::string& kind) {
        const auto found = std::find_if(list.begin(), list.end(),
                                        [&](const Named& entry) { return entry.name == word().text; });
        if (found == list.end()) fail("expected the name of " + kind + " (" + joinedNames(list) + ")");
        ++m_next;
        return static_cast<std::size_t>(found - list.begin());
    }

    [[noreturn]] void fail(const std::string& expectation) const {
        const std::string found =
            word().text.empty() ? "but the rule ends" : "but found \"" + word().text + "\"";
        throw InvalidModel("column " + std::to_string(word().column) + ": " + expectation + ", " + found);
    }

    const FuzzySystem& m_system;
    std::vector<Word> m_words; ///< the last one is empty and stands for the end
    std::size_t m_next = 0;
};

std::string clause(const std::vector<FuzzyVariable>& variables, const std::vector<FuzzyProposition>& list) {
    std::string text;
    for (const FuzzyProposition& proposition : list) {
        const FuzzyVariable& variable = variables.at(proposition.variable);
        text +=
            (text.empty() ? "" : " AND ") + variable.name + " IS " + variable.terms.at(proposition.term).name;
    }
    return text;
}

} // namespace

bool isKeyword(const std::string& word, const char* keyword) {
    const std::string expected(keyword);
    return word.size() == expected.size() &&
           std::equal(expected.begin(), expected.end(), word.begin(),
                      [](char wanted, char given) { return given == wanted || given == wanted - 'A' + 'a'; });
}

bool isKeyword(const std::string& word) {
    return isKeyword(word, "IF") || isKeyword(word, "IS") || isKeyword(word, "AND") ||
           isKeyword(word, "THEN");
}

std::string ruleText(const FuzzySystem& system, const FuzzyRule& rule) {
    return "IF " + clause(system.inputs, rule.conditions) + " THEN " +
           clause(system.outputs, rule.conclusions);
}

FuzzyRule parseRule(const FuzzySystem& system, const std::string& text) {
    return RuleParser(system, text).parse();
}

} // namespace esm

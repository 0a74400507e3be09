#include "core/exchange/fuzzy/fcl_file.h"
#include "core/exchange/fuzzy/fcl_names.h"
#include "core/exchange/fuzzy/fcl_words.h"
#include "core/fuzzy/keywords.h"
#include "core/support/joined.h"
#include "core/support/text_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace esm {

namespace {

/// What a function block consists of, and what a rule block does; a name before them ends there.
constexpr std::array blockKeywords{"VAR_INPUT", "VAR_OUTPUT", "VAR",     "FUZZIFY",
                                   "DEFUZZIFY", "RULEBLOCK",  "OPTIONS", "END_FUNCTION_BLOCK"};
constexpr std::array ruleBlockKeywords{"RULE", "AND", "OR", "ACT", "ACCU", "ENABLED", "END_RULEBLOCK"};

/// "(0 .. 10)", also with := before it and a semicolon behind it.
std::optional<std::pair<double, double>> rangeFrom(std::string text) {
    const auto isMark = [](char c) { return std::string_view("():=;").find(c) != std::string_view::npos; };
    text.erase(std::remove_if(text.begin(), text.end(), isMark), text.end());
    const std::size_t dots = text.find("..");
    if (dots == text.npos) return std::nullopt;
    const auto minimum = wholeNumber<double>(trimmed(std::string_view(text).substr(0, dots)));
    const auto maximum = wholeNumber<double>(trimmed(std::string_view(text).substr(dots + 2)));
    if (!minimum || !maximum) return std::nullopt;
    return std::pair(*minimum, *maximum);
}

class FclReader : FclWords {
public:
    explicit FclReader(const std::string& text) : FclWords(text) {
        readHead(m_draft, remarks(), word().place);
    }

    FuzzyDraft read() {
        expect("FUNCTION_BLOCK");
        const std::string name = restOfLine({blockKeywords.begin(), blockKeywords.end()});
        if (!m_draft.name && !name.empty()) m_draft.name = name;
        while (!is("END_FUNCTION_BLOCK"))
            block();
        m_draft.end = skip().place;
        if (!isAtEnd()) m_draft.warn(word().place, "what follows END_FUNCTION_BLOCK is not read");
        takeDeclaredCase(m_draft);
        return std::move(m_draft);
    }

private:
    /// Places in the list, by names in small letters.
    using Places = std::map<std::string, std::size_t>;

    void block() {
        if (accept("VAR_INPUT"))
            variables(m_draft.inputs, m_inputs);
        else if (accept("VAR_OUTPUT"))
            variables(m_draft.outputs, m_outputs);
        else if (accept("FUZZIFY"))
            fuzzify();
        else if (accept("DEFUZZIFY"))
            defuzzify();
        else if (accept("RULEBLOCK"))
            ruleBlock();
        else if (is("VAR"))
            skipBlock("END_VAR");
        else if (is("OPTIONS"))
            skipBlock("END_OPTIONS");
        else
            fail(joined({blockKeywords.begin(), blockKeywords.end() - 1}) + " or " + blockKeywords.back());
    }

    void skipBlock(const char* end) {
        m_draft.warn(word().place, word().text + " is not read");
        while (!accept(end)) {
            if (isAtEnd()) fail(end);
            skip();
        }
    }

    void variables(std::vector<DraftVariable>& list, Places& places) {
        while (!accept("END_VAR")) {
            const std::size_t first = list.size();
            do {
                const TextWord name = take("the name of a variable or END_VAR");
                places.emplace(inSmallLetters(name.text), list.size());
                addVariable(list, {{name}});
            } while (accept(","));
            expect(":");
            statement();
            takeRemarks(list, first);
        }
    }

    /// Of the variables from `first` on, which are declared together. They are many at most, and so may the
    /// remarks be.
    void takeRemarks(std::vector<DraftVariable>& list, std::size_t first) {
        DraftVariable said;
        for (const TextRemark& remark : remarksBeside(list[first].name.identifier.place)) {
            if (const auto name = remarkFor("name", remark)) said.name.name = name;
            if (const auto unit = unitFrom(remark)) said.unit = *unit;
            if (const auto range = rangeIn(remark)) said.range = range;
        }
        if (first + 1 == list.size()) list[first].name.name = said.name.name;
        for (std::size_t i = first; i < list.size(); ++i) {
            list[i].unit = said.unit;
            list[i].range = said.range;
        }
    }

    /// "RANGE(0 .. 10)"; other remarks may begin with the word as well.
    std::optional<std::pair<double, double>> rangeIn(const TextRemark& remark) {
        constexpr std::size_t length = 5;
        const std::string text(
            trimmed(std::string_view(remark.text).substr(std::min(length, remark.text.size()))));
        const bool isRange = isKeyword(remark.text.substr(0, length), "RANGE") && !text.empty();
        if (!isRange || (text.front() != '(' && text.front() != ':')) return std::nullopt;
        const auto range = rangeFrom(text);
        if (!range) m_draft.warn(remark.place, "the range is not of the form RANGE(a .. b)");
        return range;
    }

    DraftVariable& declared(std::vector<DraftVariable>& list, const Places& places, const char* kind) {
        const TextWord name = take((std::string("the name of ") + kind).c_str());
        const auto found = places.find(inSmallLetters(name.text));
        if (found == places.end()) failAt(name.place, "\"" + name.text + "\" is not declared as " + kind);
        return list[found->second];
    }

    void fuzzify() {
        DraftVariable& input = declared(m_draft.inputs, m_inputs, "an input");
        while (!accept("END_FUZZIFY"))
            if (!acceptPartOf(input)) fail("TERM or END_FUZZIFY");
    }

    void defuzzify() {
        DraftVariable& output = declared(m_draft.outputs, m_outputs, "an output");
        while (!accept("END_DEFUZZIFY")) {
            if (acceptPartOf(output)) continue;
            if (accept("METHOD"))
                method(output);
            else if (accept("ACCU"))
                settleNorm(m_draft, NormUse::Aggregation, named());
            else if (accept("DEFAULT"))
                defaultValue();
            else
                fail("TERM, METHOD, DEFAULT, RANGE or END_DEFUZZIFY");
        }
    }

    /// Of an input and of an output alike.
    bool acceptPartOf(DraftVariable& variable) {
        if (accept("TERM"))
            term(variable);
        else if (accept("RANGE"))
            range(variable);
        else if (is("LOCK") || is("ENABLED"))
            unlessItSays(is("LOCK") ? "FALSE" : "TRUE");
        else
            return false;
        return true;
    }

    /// A statement of fuzzylite's whose usual value changes nothing.
    void unlessItSays(const char* usual) {
        const TextWord subject = skip();
        const std::vector<TextWord> words = statement();
        if (words.empty() || !isKeyword(words.back().text, usual))
            m_draft.warn(subject.place, subject.text + " is not taken");
    }

    void term(DraftVariable& variable) {
        const TextWord name = take("the name of a term");
        expect(":");
        expect("=");
        std::string shape = "Discrete";
        if (!is("(")) shape = wholeNumber<double>(word().text) ? "Constant" : take("points or a number").text;
        std::vector<double> numbers;
        for (const TextWord& part : statement())
            if (part.text != "(" && part.text != ")" && part.text != ",") numbers.push_back(numberAt(part));
        DraftName draftName{name};
        for (const TextRemark& remark : remarksBeside(name.place))
            if (const auto realName = remarkFor("name", remark)) draftName.name = realName;
        addTerm(variable, draftTerm(m_draft, std::move(draftName), shape, numbers));
    }

    void range(DraftVariable& variable) {
        const TextPlace place = word().place;
        std::string text;
        for (const TextWord& part : statement())
            text += (text.empty() ? "" : " ") + part.text;
        variable.range = rangeFrom(text);
        if (!variable.range) failAt(place, "expected := (a .. b), but found \"" + text + "\"");
    }

    void method(DraftVariable& output) {
        const TextWord name = named();
        const std::string method = inSmallLetters(name.text);
        if (method == "cogs")
            output.meanOfPoints = name.place;
        else if (method != "cog" && method != "centroid")
            m_draft.warn(name.place,
                         "METHOD : " + name.text + " is not taken; values are the centre of gravity (COG)");
    }

    /// Without one, and with NC, what no rule reaches stays as it was.
    void defaultValue() {
        const TextPlace place = word().place;
        for (const TextWord& part : statement())
            if (const auto number = wholeNumber<double>(part.text); number && !std::isnan(*number))
                m_draft.warn(place, "the default value " + part.text +
                                        " is not taken; an output that no rule reaches has no value");
    }

    void ruleBlock() {
        restOfLine({ruleBlockKeywords.begin(), ruleBlockKeywords.end()}); // its name
        DraftRuleBlock block;
        while (!accept("END_RULEBLOCK")) {
            if (accept("AND"))
                block.norms.emplace_back(NormUse::Conjunction, named());
            else if (accept("OR"))
                block.norms.emplace_back(NormUse::Disjunction, named());
            else if (accept("ACT"))
                block.norms.emplace_back(NormUse::Implication, named());
            else if (accept("ACCU"))
                block.norms.emplace_back(NormUse::Aggregation, named());
            else if (is("ENABLED"))
                block.disabled = disabledHere();
            else if (accept("RULE"))
                block.rules.push_back(rule());
            else
                fail(joined({ruleBlockKeywords.begin(), ruleBlockKeywords.end() - 1}) + " or " +
                     ruleBlockKeywords.back());
        }
        takeBlock(m_draft, std::move(block));
    }

    /// The place, unless it says that the block is enabled.
    std::optional<TextPlace> disabledHere() {
        const TextPlace place = skip().place;
        const std::vector<TextWord> words = statement();
        return !words.empty() && isKeyword(words.back().text, "TRUE") ? std::nullopt : std::optional(place);
    }

    /// fuzzylite leaves out the semicolon.
    DraftRule rule() {
        while (!is(":"))
            take("the number of the rule and \":\"");
        expect(":");
        DraftRule rule;
        while (!is(";") && !is("RULE") && !is("END_RULEBLOCK") && !isAtEnd())
            rule.words.push_back(skip());
        rule.end = word().place;
        if (isAtEnd()) fail("\";\"");
        accept(";");
        return rule;
    }

    Places m_inputs, m_outputs;
    FuzzyDraft m_draft;
};

} // namespace

ImportedFuzzySystem fuzzySystemFromFcl(const Bytes& content) {
    return finished(FclReader(sourceText(content)).read());
}

} // namespace esm

#include "core/exchange/fcl_file.h"
#include "core/exchange/fcl_names.h"
#include "core/exchange/fcl_words.h"
#include "core/exchange/text_lines.h"
#include "core/fuzzy/keywords.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace esm {

namespace {

/// "0 .. 10", with or without blanks.
std::optional<std::pair<double, double>> rangeFrom(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos) return std::nullopt;
    const auto minimum = wholeNumber<double>(trimmed(text.substr(0, dots)));
    const auto maximum = wholeNumber<double>(trimmed(text.substr(dots + 2)));
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
        const std::string name = restOfLine({"VAR_INPUT", "END_FUNCTION_BLOCK"});
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
            fail("VAR_INPUT, VAR_OUTPUT, FUZZIFY, DEFUZZIFY, RULEBLOCK or END_FUNCTION_BLOCK");
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
                list.push_back({{name}});
            } while (accept(","));
            expect(":");
            statement();
            takeRemarks(list, first);
        }
    }

    void takeRemarks(std::vector<DraftVariable>& list, std::size_t first) {
        for (const TextRemark& remark : remarksBeside(list[first].name.identifier.place)) {
            if (const auto name = remarkFor("name", remark); name && first + 1 == list.size())
                list[first].name.name = name;
            for (std::size_t i = first; i < list.size(); ++i)
                list[i].unit = remarkFor("unit", remark).value_or(list[i].unit);
            if (!isKeyword(remark.text.substr(0, 5), "RANGE")) continue;
            std::string text = remark.text.substr(5);
            text.erase(std::remove_if(text.begin(), text.end(),
                                      [](char c) {
                                          return std::string_view("():=;").find(c) != std::string_view::npos;
                                      }),
                       text.end());
            const auto range = rangeFrom(text);
            if (!range) m_draft.warn(remark.place, "the range is not of the form RANGE(a .. b)");
            for (std::size_t i = first; range && i < list.size(); ++i)
                list[i].range = range;
        }
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
                norm(m_draft.norms.aggregation);
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
        variable.terms.push_back(draftTerm(m_draft, std::move(draftName), shape, numbers));
    }

    void range(DraftVariable& variable) {
        const TextPlace place = word().place;
        std::string text;
        for (const TextWord& part : statement())
            if (std::string_view("():=").find(part.text) == std::string_view::npos) text += part.text + " ";
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

    template<class Norm> void norm(std::optional<Norm>& slot) { settleNorm(m_draft, slot, named()); }

    /// Without one, and with NC, what no rule reaches stays as it was.
    void defaultValue() {
        const TextPlace place = word().place;
        for (const TextWord& part : statement())
            if (const auto number = wholeNumber<double>(part.text); number && !std::isnan(*number))
                m_draft.warn(place, "the default value " + part.text +
                                        " is not taken; an output that no rule reaches has no value");
    }

    void ruleBlock() {
        restOfLine({"AND", "OR", "ACT", "ACCU", "RULE", "END_RULEBLOCK"}); // its name
        while (!accept("END_RULEBLOCK")) {
            if (accept("AND"))
                norm(m_draft.norms.conjunction);
            else if (accept("OR"))
                norm(m_draft.norms.disjunction);
            else if (accept("ACT"))
                norm(m_draft.norms.implication);
            else if (accept("ACCU"))
                norm(m_draft.norms.aggregation);
            else if (is("ENABLED"))
                unlessItSays("TRUE");
            else if (accept("RULE"))
                rule();
            else
                fail("RULE, AND, OR, ACT, ACCU or END_RULEBLOCK");
        }
    }

    /// fuzzylite leaves out the semicolon.
    void rule() {
        while (!is(":"))
            take("the number of the rule and \":\"");
        expect(":");
        DraftRule rule;
        while (!is(";") && !is("RULE") && !is("END_RULEBLOCK") && !isAtEnd())
            rule.words.push_back(skip());
        rule.end = word().place;
        if (isAtEnd()) fail("\";\"");
        accept(";");
        m_draft.rules.push_back(std::move(rule));
    }

    Places m_inputs, m_outputs;
    FuzzyDraft m_draft;
};

} // namespace

ImportedFuzzySystem fuzzySystemFromFcl(const Bytes& content) {
    return finished(FclReader(sourceText(content)).read());
}

} // namespace esm

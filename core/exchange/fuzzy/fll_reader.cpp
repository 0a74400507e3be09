#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_draft.h"
#include "core/exchange/fuzzy/fuzzy_norm_names.h"
#include "core/fuzzy/keywords.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace esm {

namespace {

/// "key: value", with the words of the value and their places.
struct FllLine {
    TextWord key;
    std::string value;
    std::vector<TextWord> words;
    TextPlace end;
};

FllLine fllLine(std::string_view code, std::size_t number) {
    const std::vector<TextWord> all = textWords(code, {number, 1}, ":()");
    const std::size_t colon = code.find(':');
    if (colon == code.npos || all.front().text == ":")
        failAt(all.front().place,
               "expected a key and a colon, as in \"Engine: name\", but found \"" + all.front().text + "\"");
    const TextPlace behindColon{number, letterCount(code.substr(0, colon + 1)) + 1};
    const std::string_view value = code.substr(colon + 1);
    return {{std::string(trimmed(code.substr(0, colon))), all.front().place},
            std::string(trimmed(value)),
            textWords(value, behindColon, "()"),
            {number, letterCount(code) + 1}};
}

class FllReader {
public:
    explicit FllReader(const std::string& text) : m_source(withoutRemarks(text, {{"#", "\n"}})) {
        m_draft.end = m_source.end;
        for (const TextRemark& remark : m_source.remarks) {
            if (const auto name = remarkFor("name", remark)) m_names[remark.place.line] = *name;
            if (const auto unit = unitFrom(remark)) m_units[remark.place.line] = *unit;
        }
    }

    FuzzyDraft read() {
        bool isHead = true;
        std::size_t number = 0;
        std::string_view rest(m_source.code);
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view code = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            ++number;
            if (trimmed(code).empty()) continue;
            if (isHead) readHead(m_draft, m_source.remarks, {number, 1});
            isHead = false;
            line(fllLine(code, number));
        }
        endBlock();
        return std::move(m_draft);
    }

private:
    enum class Part { Engine, Input, Output, RuleBlock };

    void line(const FllLine& line) {
        const auto is = [&](const char* key) { return isKeyword(line.key.text, key); };
        if (is("ENGINE")) {
            m_part = Part::Engine;
            if (!m_draft.name && !line.value.empty()) m_draft.name = line.value;
        } else if (is("INPUTVARIABLE") || is("OUTPUTVARIABLE")) {
            m_part = is("INPUTVARIABLE") ? Part::Input : Part::Output;
            addVariable(variables(), {nameOf(line)});
        } else if (is("RULEBLOCK")) {
            endBlock();
            m_part = Part::RuleBlock;
        } else if (is("DESCRIPTION")) {
            description(line);
        } else if (m_part == Part::Engine) {
            failAtKey(line, "Engine, InputVariable, OutputVariable or RuleBlock");
        } else if (m_part == Part::RuleBlock) {
            ruleBlock(line);
        } else {
            variable(line);
        }
    }

    [[noreturn]] static void failAtKey(const FllLine& line, const std::string& expected) {
        failAt(line.key.place, "expected " + expected + ", but found \"" + line.key.text + "\"");
    }

    static const TextWord& word(const FllLine& line, std::size_t index, const char* expected) {
        if (index >= line.words.size())
            failAt(line.end, std::string("expected ") + expected + ", but the line ends");
        return line.words[index];
    }

    /// Of a variable. One of a million words would be repeated in every problem.
    DraftName nameOf(const FllLine& line) const {
        const TextPlace place = word(line, 0, "a name").place;
        if (line.words.size() > 1) failAt(place, nameProblem(line.words[0].text + " " + line.words[1].text));
        return {line.words[0], realName(line)};
    }

    std::vector<DraftVariable>& variables() {
        return m_part == Part::Input ? m_draft.inputs : m_draft.outputs;
    }

    /// By line.
    using Remarks = std::map<std::size_t, std::string>;

    static std::optional<std::string> remarkBeside(const FllLine& line, const Remarks& remarks) {
        const auto remark = remarks.find(line.key.place.line);
        return remark == remarks.end() ? std::nullopt : std::optional(remark->second);
    }

    std::optional<std::string> realName(const FllLine& line) const { return remarkBeside(line, m_names); }

    void description(const FllLine& line) {
        if (line.value.empty()) return;
        if (m_part == Part::Engine && m_draft.description.empty())
            m_draft.description = line.value;
        else if (m_part != Part::Engine)
            m_draft.warn(line.key.place, "the description is not taken; only a system has one");
    }

    static bool flag(const FllLine& line) {
        const TextWord& value = word(line, 0, "true or false");
        if (!isKeyword(value.text, "TRUE") && !isKeyword(value.text, "FALSE"))
            failAt(value.place, "expected true or false, but found \"" + value.text + "\"");
        return isKeyword(value.text, "TRUE");
    }

    void variable(const FllLine& line) {
        const auto is = [&](const char* key) { return isKeyword(line.key.text, key); };
        DraftVariable& variable = variables().back();
        if (is("TERM"))
            term(variable, line);
        else if (is("RANGE"))
            range(variable, line);
        else if (is("ENABLED"))
            warnUnless(flag(line), line, "it is not enabled, but is taken as if it were");
        else if (is("LOCK-RANGE")) // no output goes beyond its range
            warnUnless(!flag(line) || m_part == Part::Output, line, "values are not held within the range");
        else if (m_part != Part::Output || !acceptOfOutput(variable, line))
            failAtKey(line, m_part == Part::Input
                                ? "term, range, enabled or lock-range"
                                : "term, range, aggregation, defuzzifier, default, enabled, lock-previous or "
                                  "lock-range");
    }

    void range(DraftVariable& variable, const FllLine& line) {
        const double minimum = numberAt(word(line, 0, "a number"));
        variable.range = {minimum, numberAt(word(line, 1, "a number"))};
        variable.unit = remarkBeside(line, m_units).value_or("");
    }

    bool acceptOfOutput(DraftVariable& output, const FllLine& line) {
        const auto is = [&](const char* key) { return isKeyword(line.key.text, key); };
        if (is("AGGREGATION") || is("ACCUMULATION"))
            settleNorm(m_draft, NormUse::Aggregation, word(line, 0, "a norm"));
        else if (is("DEFUZZIFIER"))
            defuzzifier(output, line);
        else if (is("DEFAULT"))
            warnUnless(std::isnan(numberAt(word(line, 0, "a number"))), line,
                       "it is not taken; an output that no rule reaches has no value");
        else if (is("LOCK-PREVIOUS") || is("LOCK-VALID"))
            warnUnless(!flag(line), line, "it is not taken; an output that no rule reaches has no value");
        else
            return false;
        return true;
    }

    void warnUnless(bool isUsual, const FllLine& line, const std::string& text) {
        if (!isUsual) m_draft.warn(line.key.place, line.key.text + " " + line.value + ": " + text);
    }

    void term(DraftVariable& variable, const FllLine& line) {
        DraftName name{word(line, 0, "the name of a term"), realName(line)};
        const std::string shape = word(line, 1, "a shape, as in \"Trapezoid 0 1 2 3\"").text;
        std::vector<double> numbers;
        if (isKeyword(shape, "FUNCTION"))
            failAt(line.words[1].place, "a term that is a formula cannot be taken");
        for (std::size_t i = 2; i < line.words.size(); ++i)
            numbers.push_back(numberAt(line.words[i]));
        addTerm(variable, draftTerm(m_draft, std::move(name), shape, numbers));
    }

    void defuzzifier(DraftVariable& output, const FllLine& line) {
        const TextWord& name = word(line, 0, "a defuzzifier");
        if (isKeyword(name.text, "CENTROID")) return;
        if (isKeyword(name.text, "WEIGHTEDAVERAGE"))
            output.meanOfPoints = name.place;
        else
            m_draft.warn(name.place, "the defuzzifier " + name.text +
                                         " is not taken; values are the centre of gravity (Centroid)");
    }

    void ruleBlock(const FllLine& line) {
        const auto is = [&](const char* key) { return isKeyword(line.key.text, key); };
        if (is("RULE"))
            m_block.rules.push_back({line.words, line.end});
        else if (is("CONJUNCTION"))
            norm(NormUse::Conjunction, line);
        else if (is("DISJUNCTION"))
            norm(NormUse::Disjunction, line);
        else if (is("IMPLICATION"))
            norm(NormUse::Implication, line);
        else if (is("ACTIVATION"))
            activation(line);
        else if (is("ENABLED"))
            m_block.disabled = flag(line) ? std::nullopt : std::optional(line.key.place);
        else
            failAtKey(line, "rule, conjunction, disjunction, implication, activation or enabled");
    }

    void norm(NormUse use, const FllLine& line) { m_block.norms.emplace_back(use, word(line, 0, "a norm")); }

    /// In fuzzylite 5 the implication went by this key.
    void activation(const FllLine& line) {
        const TextWord& name = word(line, 0, "General");
        if (foreignTNorm(name.text))
            norm(NormUse::Implication, line);
        else if (!isKeyword(name.text, "GENERAL") && !isKeyword(name.text, "NONE"))
            m_draft.warn(name.place, "the activation " + name.text + " is not taken; every rule fires");
    }

    void endBlock() { takeBlock(m_draft, std::exchange(m_block, {})); }

    SourceCode m_source;
    Remarks m_names; ///< real ones
    Remarks m_units;
    Part m_part = Part::Engine;
    DraftRuleBlock m_block; ///< the last one so far
    FuzzyDraft m_draft;
};

} // namespace

ImportedFuzzySystem fuzzySystemFromFll(const Bytes& content) {
    return finished(FllReader(sourceText(content)).read());
}

} // namespace esm

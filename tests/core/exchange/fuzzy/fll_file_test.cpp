#include "core/exchange/fuzzy/fll_file.h"

#include "core/exchange/fuzzy/fcl_file.h"
#include "core/fuzzy/rule_text.h"
#include "tests/core/exchange/fuzzy/fuzzy_text_files.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {

std::string soundFll() {
    return R"(Engine: dimmer
InputVariable: Ambient
  enabled: true
  range: 0.000 1.000
  lock-range: false
  term: DARK Triangle 0.000 0.250 0.500
  term: BRIGHT Ramp 0.500 0.750
OutputVariable: Power
  enabled: true
  range: 0.000 1.000
  lock-range: false
  aggregation: Maximum
  defuzzifier: Centroid 200
  default: nan
  lock-previous: false
  term: LOW Trapezoid 0.000 0.000 0.250 0.500
  term: HIGH Discrete 0.500 0.000 0.750 1.000 1.000 1.000
RuleBlock: light
  enabled: true
  conjunction: none
  disjunction: none
  implication: Minimum
  activation: General
  rule: if Ambient is DARK then Power is HIGH
  rule: if Ambient is not DARK then Power is LOW with 0.5
)";
}

const TextLanguage fllLanguage{fuzzySystemFromFll, toFll};

std::string fllComplaint(const std::string& part, const std::string& by) {
    return complaintOf(fuzzySystemFromFll, withReplaced(soundFll(), part, by));
}

std::string fllWarning(const std::string& part, const std::string& by) {
    const std::vector<std::string> warnings =
        fllLanguage.readText(withReplaced(soundFll(), part, by)).warnings;
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
}

} // namespace

TEST(FllFile, ComesBackAsItWasWritten) {
    fllLanguage.expectAllBack(2);
}

TEST(FllFile, SaysNotBeforeBracketsOtherwise) {
    const FuzzySystem system = fllLanguage
                                   .readText(withReplaced(soundFll(), "if Ambient is DARK",
                                                          "if not (Ambient is DARK or Ambient is BRIGHT)"))
                                   .system;
    FuzzySystem written = system;
    written.rules[0] =
        parseRule(system, "IF Ambient IS NOT DARK AND Ambient IS NOT BRIGHT THEN Power IS HIGH");
    EXPECT_EQ(fllLanguage.readText(toFll(system).text).system, written);
    EXPECT_EQ(fuzzySystemFromFcl(bytesOf(toFcl(system).text)).system, system);
}

TEST(FllFile, IsWrittenAsFuzzyliteHasIt) {
    const std::string text = toFll(fuzzyPreset("susilap-g")).text;
    for (const char* part :
         {"# name: susilap-g\n", "Engine: susilap_g\n",
          "InputVariable: consistency\n  enabled: true\n  range: 0 12\n",
          "  term: soft Trapezoid 2.5 3 3.5 4\n", "  aggregation: Maximum\n  defuzzifier: Centroid 200\n",
          "  implication: Minimum\n  activation: General\n  rule: if consistency is "})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST(FllFile, IsRead) {
    const auto [system, warnings] = fllLanguage.readText(soundFll());
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(system.name, "dimmer");
    EXPECT_EQ(system.inputs[0].terms[0].set.c, 0.25);
    EXPECT_EQ(system.inputs[0].terms[1].set.a, 0.5);
    EXPECT_EQ(system.inputs[0].terms[1].set.d, 1);
    EXPECT_EQ(system.outputs[0].terms[1].set.d, 1);
    EXPECT_EQ(ruleText(system, system.rules[1]), "IF Ambient IS NOT DARK THEN Power IS LOW WITH 0.5");
}

TEST(FllFile, IsReadAsOlderOnesAreWritten) {
    std::string text = withReplaced(soundFll(), "  implication: Minimum\n  activation: General",
                                    "activation: BoundedDifference");
    text = withReplaced(text, "aggregation: Maximum", "ACCUMULATION: AlgebraicSum # more");
    text = withReplaced(text, "Triangle 0.000 0.250 0.500", "Triangle -inf 0.250 0.500 1.000\r");
    text = withReplaced(text, "Engine: dimmer\n", "Engine: dimmer\n  description: of a lamp\n");
    const auto [system, warnings] = fllLanguage.readText("\xEF\xBB\xBF" + text);
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(system.description, "of a lamp");
    EXPECT_EQ(system.norms.implication, TNorm::BoundedDifference);
    EXPECT_EQ(system.norms.aggregation, TConorm::ProbabilisticSum);
    EXPECT_EQ(system.inputs[0].terms[0].set.a, 0);
}

TEST(FllFile, TellsWhatItDidNotTake) {
    EXPECT_THAT(fllWarning("Centroid 200", "Bisector 200"),
                StartsWith("line 13, column 16: the defuzzifier Bisector"));
    EXPECT_EQ(fllWarning("Centroid 200", "WeightedAverage"), "2 warnings"); // one for each term
    EXPECT_THAT(fllWarning("default: nan", "default: 0.5"),
                StartsWith("line 14, column 3: default 0.5: it is not"));
    EXPECT_THAT(fllWarning("lock-previous: false", "lock-previous: true"), StartsWith("line 15, column 3: "));
    EXPECT_THAT(fllWarning("lock-range: false", "lock-range: true"), StartsWith("line 5, column 3: "));
    EXPECT_THAT(fllWarning("enabled: true", "enabled: false"), StartsWith("line 3, column 3: "));
    EXPECT_THAT(fllWarning("General", "Highest 1"), StartsWith("line 23, column 15: the activation Highest"));
    EXPECT_THAT(fllWarning("Triangle 0.000 0.250 0.500", "Bell 0.2 0.1 3"),
                StartsWith("line 6, column 9: the term DARK"));
    EXPECT_THAT(fllWarning("range: 0.000 1.000", "range: -inf inf"),
                StartsWith("line 2, column 16: Ambient has no range"));
    EXPECT_THAT(fllWarning("  enabled: true\n  range", "  description: light\n  range"),
                StartsWith("line 3, column 3: "));
    EXPECT_EQ(fllWarning("true\n  conjunction", "false\n  conjunction"), "2 warnings"); // no rules are left
    const std::string disabled =
        "RuleBlock: a\nconjunction: AlgebraicProduct\nimplication: BoundedDifference\n"
        "rule: nonsense\nenabled: false\n";
    EXPECT_EQ(fllWarning("RuleBlock:", disabled + "RuleBlock:"),
              "line 22, column 1: the rule block is not enabled; its rules and norms are not taken");
    EXPECT_EQ(
        fllLanguage.readText(withReplaced(soundFll(), "RuleBlock:", disabled + "RuleBlock:")).system.norms,
        FuzzyNorms());
    EXPECT_THAT(fllWarning("RuleBlock:", "OutputVariable: y\n aggregation: BoundedSum\n term: x Constant 1\n "
                                         "term: y Constant 2\nRuleBlock:"),
                HasSubstr("2 warnings")); // of the norm, and of the range
}

TEST(FllFile, NamesThePlaceOfWhatIsWrong) {
    const auto wrong = fllComplaint;
    EXPECT_THAT(wrong("Engine: dimmer", "FUNCTION_BLOCK x"),
                StartsWith("line 1, column 1: expected a key and a colon"));
    EXPECT_THAT(wrong("Engine: dimmer", "Motor: dimmer"), StartsWith("line 1, column 1: expected Engine, "));
    EXPECT_THAT(wrong("range: 0.000 1.000", "range: 0.000"),
                StartsWith("line 4, column 15: expected a number, but the line"));
    EXPECT_THAT(wrong("range: 0.000 1.000", "range: zäh x"),
                StartsWith("line 4, column 10: expected a number"));
    EXPECT_THAT(wrong("range: 0.000 1.000", "range: 1 0"),
                HasSubstr("line 2, column 16: inputs.Ambient.range"));
    EXPECT_THAT(wrong("lock-range", "luck-range"), StartsWith("line 5, column 3: expected term, range"));
    EXPECT_THAT(wrong("0.250 0.500", "0.250"),
                StartsWith("line 6, column 9: the term DARK: a triangle takes 3"));
    EXPECT_THAT(wrong("0.250 0.500", "0.250 0.500 0.5"), HasSubstr("height 0.5"));
    EXPECT_THAT(wrong("0.250 0.500", "0.750 0.500"),
                HasSubstr("line 6, column 9: inputs.Ambient.terms.DARK: the corners"));
    EXPECT_THAT(wrong("Triangle 0.000 0.250 0.500", "Function x+1"),
                StartsWith("line 6, column 14: a term that is a"));
    EXPECT_THAT(wrong("Triangle 0.000 0.250 0.500", "Linear 1 2"),
                HasSubstr("the shape \"Linear\" cannot be taken"));
    EXPECT_THAT(wrong("enabled: true", "enabled: yes"),
                StartsWith("line 3, column 12: expected true or false"));
    EXPECT_THAT(wrong("conjunction: none", "conjunction: EinsteinProduct"),
                StartsWith("line 20, column 16: the norm"));
    EXPECT_THAT(wrong("is DARK then", "is very DARK then"), HasSubstr("line 24, column 23: expected"));
    EXPECT_THAT(wrong("Power is HIGH", "Power is"),
                HasSubstr("line 24, column 41: expected the name of a term"));
    EXPECT_THAT(wrong("  term: LOW", "  term"), StartsWith("line 16, column 3: expected a key and a colon"));
    EXPECT_THAT(wrong("InputVariable: Ambient", "InputVariable:"),
                StartsWith("line 2, column 15: expected a name"));
    EXPECT_THAT(wrong("InputVariable: Ambient", "InputVariable: the light"),
                StartsWith("line 2, column 16: a name is one word"));
    std::string words;
    for (int i = 0; i < 100000; ++i)
        words += " word" + std::to_string(i);
    EXPECT_EQ(wrong("InputVariable: Ambient", "InputVariable:" + words),
              wrong("InputVariable: Ambient", "InputVariable: the light"));
    EXPECT_THAT(complaintOf(fuzzySystemFromFll, ""), StartsWith("line 1, column 1: inputs: there must be"));
}

TEST(FllFile, TruncatedNeverDoesHarm) {
    const std::string text = toFll(fuzzyPreset("susilap-g")).text;
    for (std::size_t size = 0; size < text.size(); size += 7) {
        const std::string complaint = complaintOf(fuzzySystemFromFll, text.substr(0, size));
        EXPECT_TRUE(complaint == "accepted" || complaint.compare(0, 5, "line ") == 0) << complaint;
    }
}

#include "core/exchange/fuzzy/fcl_file.h"

#include "core/fuzzy/rule_text.h"
#include "tests/core/exchange/fuzzy/fuzzy_text_files.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {

std::string soundFcl() {
    return R"(FUNCTION_BLOCK tipper
VAR_INPUT
  service : REAL; (* RANGE(0 .. 9) *)
  food : REAL;
END_VAR
VAR_OUTPUT
  tip : REAL;
END_VAR
FUZZIFY service
  TERM poor := (0, 1) (4, 0);
  TERM good := (1, 0) (4, 1) (6, 1) (9, 0);
END_FUZZIFY
FUZZIFY food
  TERM rancid := (0, 1) (1, 1) (3, 0);
  TERM delicious := (7, 0) (9, 1);
END_FUZZIFY
DEFUZZIFY tip
  RANGE := (0 .. 30);
  TERM cheap := (0, 0) (5, 1) (10, 0);
  TERM average := (10, 0) (15, 1) (20, 0);
  METHOD : COG;
END_DEFUZZIFY
RULEBLOCK No1
  AND : MIN;
  ACT : MIN;
  ACCU : MAX;
  RULE 1 : IF service IS poor OR food IS rancid THEN tip IS cheap;
  RULE 2 : IF service IS good THEN tip IS average;
END_RULEBLOCK
END_FUNCTION_BLOCK
)";
}

const TextLanguage fclLanguage{fuzzySystemFromFcl, toFcl};

std::string fclComplaint(const std::string& part, const std::string& by) {
    return complaintOf(fuzzySystemFromFcl, withReplaced(soundFcl(), part, by));
}

std::vector<std::string> fclWarnings(const std::string& part, const std::string& by) {
    return fclLanguage.readText(withReplaced(soundFcl(), part, by)).warnings;
}

} // namespace

TEST(FclFile, ComesBackAsItWasWritten) {
    fclLanguage.expectAllBack(1);
}

TEST(FclFile, IsWrittenAsTheStandardHasIt) {
    const std::string text = toFcl(fuzzyPreset("susilap-g")).text;
    for (const char* part :
         {"(* name: susilap-g *)\n", "FUNCTION_BLOCK susilap_g\n",
          "  consistency : REAL; (* RANGE(0 .. 12) *)\n", "  TERM very_soft := (0, 1) (2.5, 1) (3, 0);\n",
          "  TERM soft := (2.5, 0) (3, 1) (3.5, 1) (4, 0);\n",
          "DEFUZZIFY spring_const\n  RANGE := (0 .. 100);\n", "  METHOD : COG;\nEND_DEFUZZIFY\n",
          "  AND : MIN;\n  OR : MAX;\n  ACT : MIN;\n  ACCU : MAX;\n  RULE 1 : IF consistency IS "})
        EXPECT_THAT(text, HasSubstr(part));
    EXPECT_EQ(toFcl(awkwardSystem()).warnings.size(), 3); // names, ACT and ACCU
}

TEST(FclFile, IsRead) {
    const auto [system, warnings] = fclLanguage.readText(soundFcl());
    EXPECT_EQ(system.name, "tipper");
    EXPECT_EQ(system.inputs[0].maximum, 9);
    EXPECT_EQ(system.inputs[0].terms[0].set.b, 0);
    EXPECT_EQ(system.inputs[1].terms[1].set.d, 9);
    EXPECT_EQ(system.outputs[0].terms[1].set.c, 15);
    EXPECT_EQ(ruleText(system, system.rules[0]), "IF service IS poor OR food IS rancid THEN tip IS cheap");
    EXPECT_THAT(warnings,
                ElementsAre("line 4, column 3: food has no range; it is taken from its terms, 0 to 9"));
}

TEST(FclFile, IsReadAsOthersWriteIt) {
    std::string text = soundFcl();
    text = withReplaced(text, "(0, 1) (4, 0)", "TRAPE 0 0 0 4");
    text = withReplaced(text, "(5, 1)", "(5, 1) // remark\n /* more\n (* *)*/ (7.5, 0.5)");
    text = withReplaced(text, "TERM average := (10, 0) (15, 1) (20, 0)",
                        "term average := Triangle 10.0 15.0 20.0");
    text = withReplaced(text, "THEN tip IS cheap;", "then TIP is Cheap, tip is average WITH 0.5");
    text = withReplaced(text, "FUZZIFY food", "fuzzify food\r\n RANGE:=(0..9);\r\n");
    text = withReplaced(text, "ACT : MIN;", "OR:ASUM; ACT : none;");
    text = withReplaced(text, "AND : MIN;", "");
    text = withReplaced(text, "food : REAL;", "food : REAL; // name: of a dish");
    const auto [system, warnings] = fclLanguage.readText("\xEF\xBB\xBF" + text);
    EXPECT_EQ(system.inputs[1].name, "food");
    EXPECT_THAT(warnings, IsEmpty());
    EXPECT_EQ(ruleText(system, system.rules[0]),
              "IF service IS poor OR food IS rancid THEN tip IS cheap AND tip IS average WITH 0.5");
    EXPECT_EQ(system.inputs[0].terms[0].set.d, 4);
    EXPECT_EQ(system.outputs[0].terms[0].set.d, 10);
    EXPECT_EQ(system.norms.disjunction, TConorm::ProbabilisticSum);
    EXPECT_EQ(system.norms.conjunction, TNorm::Product); // goes with it
}

TEST(FclFile, NamesOfRulesAreThoseOfTheirDeclarations) {
    std::string text = withReplaced(soundFcl(), "TERM rancid", "TERM Poor");
    text = withReplaced(text, "food IS rancid", "FOOD IS POOR");
    text = withReplaced(text, "service IS poor", "Service IS pooR");
    const FuzzySystem system = fclLanguage.readText(text).system;
    EXPECT_EQ(ruleText(system, system.rules[0]), "IF service IS poor OR food IS Poor THEN tip IS cheap");
}

TEST(FclFile, TellsWhatItDidNotTake) {
    EXPECT_THAT(fclWarnings("COG", "COA").back(),
                StartsWith("line 21, column 12: METHOD : COA is not taken"));
    EXPECT_THAT(fclWarnings("COG;", "COG; DEFAULT := 5;").back(),
                StartsWith("line 21, column 25: the default value 5"));
    EXPECT_THAT(fclWarnings("COG", "COGS"), testing::SizeIs(3));
    EXPECT_THAT(fclWarnings("ACCU : MAX", "ACCU : NSUM").back(),
                StartsWith("line 26, column 10: NSUM is taken as"));
    EXPECT_THAT(fclWarnings("(0 .. 9)", "(0)").at(1), StartsWith("line 3, column 19: the range"));
    EXPECT_THAT(fclWarnings("(0, 1) (4, 0)", "gauss 2 1").back(),
                StartsWith("line 10, column 8: the term poor: gaussian"));
    EXPECT_THAT(fclWarnings("VAR_OUTPUT", "VAR x : REAL; END_VAR VAR_OUTPUT").back(),
                StartsWith("line 6, column 1: VAR"));
    EXPECT_THAT(fclLanguage.readText(soundFcl() + "FUNCTION_BLOCK x").warnings.back(),
                StartsWith("line 31, column 1: what follows"));
}

TEST(FclFile, NamesThePlaceOfWhatIsWrong) {
    const auto wrong = fclComplaint;
    EXPECT_EQ(wrong("FUNCTION_BLOCK", "Zäh"), "line 1, column 1: expected FUNCTION_BLOCK, but found \"Zäh\"");
    EXPECT_THAT(wrong("(0, 1) (4, 0)", "(0, 1) (4, 0.5)"),
                StartsWith("line 10, column 8: the term poor: a side"));
    EXPECT_THAT(wrong("(0, 1) (4, 0)", "(0, 1) (x, 0)"), StartsWith("line 10, column 24: expected a number"));
    EXPECT_THAT(wrong("(0, 1) (4, 0)", "(4, 1) (0, 0)"),
                StartsWith("line 10, column 8: the term poor: points"));
    EXPECT_THAT(wrong("(0, 1) (4, 0)", "gauss2 1 2 3 4"),
                StartsWith("line 10, column 8: the term poor: the shape"));
    EXPECT_THAT(wrong("good :=", "poor :="),
                HasSubstr("line 11, column 8: inputs.service.terms.poor: the name is"));
    EXPECT_THAT(wrong("food : REAL;", "food : REAL; fish : REAL;"),
                HasSubstr("line 4, column 16: inputs.fish.terms"));
    EXPECT_THAT(wrong("FUZZIFY food", "FUZZIFY fish"),
                StartsWith("line 13, column 9: \"fish\" is not declared"));
    EXPECT_THAT(wrong("(0 .. 30)", "(30 .. 0)"), HasSubstr("line 7, column 3: outputs.tip.range"));
    EXPECT_THAT(wrong("(0 .. 30)", "(0, 30)"), StartsWith("line 18, column 9: expected := (a .. b)"));
    EXPECT_THAT(wrong("AND : MIN", "AND : HPROD"), StartsWith("line 24, column 9: the norm \"HPROD\""));
    EXPECT_THAT(wrong("THEN tip IS cheap", ""),
                HasSubstr("line 27, column 49: expected AND, OR or THEN, but the rule"));
    EXPECT_THAT(wrong("IS rancid", "IS very rancid"), HasSubstr("line 27, column 42: expected"));
    EXPECT_THAT(wrong("IS rancid", "IS very rancid"), HasSubstr("hedges"));
    EXPECT_THAT(wrong("IS cheap", "IS costly"),
                HasSubstr("line 27, column 61: expected the name of a term of tip"));
    EXPECT_THAT(wrong("END_RULEBLOCK", ""), StartsWith("line 30, column 1: expected RULE"));
    EXPECT_THAT(wrong("(* RANGE(0 .. 9) *)", "(* RANGE"),
                StartsWith("line 3, column 19: the remark does not end"));
}

TEST(FclFile, IsRefusedWhenTruncatedAnywhere) {
    const std::string text = toFcl(fuzzyPreset("susilap-g")).text;
    for (std::size_t size = 0; size + sizeof "END_FUNCTION_BLOCK" < text.size(); size += 7)
        EXPECT_THAT(complaintOf(fuzzySystemFromFcl, text.substr(0, size)), StartsWith("line ")) << size;
}

TEST(FclFile, IsRefusedWhereItIsNoText) {
    const auto complaint = [](const std::string& text) { return complaintOf(fuzzySystemFromFcl, text); };
    EXPECT_THAT(complaint(std::string("F\0U\0N\0", 6)), StartsWith("line 1, column 1: is UTF-16 text"));
    EXPECT_THAT(complaint("\xFF\xFE"), StartsWith("line 1, column 1: is UTF-16 text"));
    EXPECT_THAT(complaint("FUNCTION_BLOCK a\nz\xE4h"), StartsWith("line 2, column 2: is not UTF-8"));
    EXPECT_THAT(complaint("FUNCTION_BLOCK a\n\x01"), StartsWith("line 2, column 1: is not text"));
    EXPECT_THAT(complaint(std::string(5 << 20, ' ')), HasSubstr("too large"));
    EXPECT_THAT(complaint("FUNCTION_BLOCK " + std::string(1000, 'x')),
                StartsWith("line 1, column 16: there is a word"));
    EXPECT_THAT(complaint(""), StartsWith("line 1, column 1: expected FUNCTION_BLOCK, but the file ends"));
}

TEST(FclFile, IsReadInTimeHoweverLong) {
    const auto wrong = fclComplaint;
    std::string rules, brackets(1 << 17, '('), terms;
    for (int i = 0; i < 10000; ++i) {
        rules += "RULE 1 : IF service IS poor THEN tip IS cheap;\n";
        terms += "TERM t" + std::to_string(i) + " := 1;\n";
    }
    EXPECT_THAT(wrong("RULE 1", rules + "RULE 1"),
                StartsWith("line 2027, column 10: rules: there are 10002"));
    EXPECT_THAT(wrong("IF service", "IF " + brackets + "service"),
                StartsWith("line 27, column 115: brackets and NOT"));
    EXPECT_THAT(wrong("TERM poor", terms + "TERM poor"), HasSubstr("more than 2000 terms"));
}

TEST(FclFile, IsReadInTimeHoweverManyRemarksStandBesideHoweverManyNames) {
    std::string names = "v0", remarks;
    for (int i = 1; i < 60000; ++i)
        names += ",v" + std::to_string(i);
    for (int i = 0; i < 40000; ++i)
        remarks += "(*unit:x*)";
    EXPECT_THAT(fclComplaint("food : REAL;", names + " : REAL; " + remarks),
                HasSubstr("there are more than 2000 variables"));
    names.resize(names.find(",v1990"));
    EXPECT_THAT(fclComplaint("food : REAL;", "food, " + names + " : REAL; " + remarks),
                HasSubstr("inputs.v0.terms: there must be at least one"));
    EXPECT_THAT(fclComplaint("food : REAL;",
                             "food, " + names + " : REAL; (*unit: " + std::string(1 << 20, 'x') + "*)"),
                HasSubstr("a unit may have 500 bytes"));
}

TEST(FclFile, TakesNothingFromARuleBlockThatIsNotEnabled) {
    const std::string disabled = "RULEBLOCK a ENABLED : FALSE; AND : PROD; ACCU : BSUM; RULE 1 : nonsense; "
                                 "END_RULEBLOCK ";
    const auto [system, warnings] =
        fclLanguage.readText(withReplaced(soundFcl(), "RULEBLOCK No1", disabled + "RULEBLOCK No1"));
    EXPECT_EQ(system.rules.size(), 2U);
    EXPECT_EQ(system.norms, FuzzyNorms());
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[1],
              "line 23, column 13: the rule block is not enabled; its rules and norms are not taken");
    EXPECT_EQ(fclWarnings("RULEBLOCK No1", "RULEBLOCK No1 ENABLED : TRUE;").size(), 1U);
}

TEST(FclFile, MayGoOnBehindANameOnTheSameLine) {
    std::string text = soundFcl();
    const std::size_t outputs = text.find("VAR_OUTPUT"), fuzzify = text.find("FUZZIFY service");
    const std::string declared = text.substr(outputs, fuzzify - outputs);
    text = withReplaced(text.erase(outputs, fuzzify - outputs), "FUNCTION_BLOCK tipper",
                        "FUNCTION_BLOCK the tipper " + declared);
    const FuzzySystem system = fclLanguage.readText(text).system;
    EXPECT_EQ(system.name, "the tipper");
    EXPECT_EQ(system.outputs.size(), 1U);
}

TEST(FclFile, TakesForARangeOnlyWhatLooksLikeOne) {
    EXPECT_EQ(fclWarnings("food : REAL;", "food : REAL; (* Range finder, mm *)").size(), 1U);
    EXPECT_EQ(fclWarnings("food : REAL;", "food : REAL; (* range := (0 .. 9); *)").size(), 0U);
}

TEST(FclFile, ReadsNoZeroByteFromRemarks) {
    EXPECT_EQ(fclLanguage.readText("(* note: a\\x00b\\x09c *)\n" + soundFcl()).system.note, "a\\x00b\tc");
    FuzzySystem system = fuzzyPreset("susilap-g");
    system.note = std::string("a\0b", 3);
    EXPECT_EQ(fclLanguage.readText(toFcl(system).text).system.note, "ab");
}

TEST(FclFile, WritesNoExponentWithoutAPoint) {
    FuzzySystem system = fuzzyPreset("susilap-g");
    system.rules[0].weight = 1e-5;
    EXPECT_THAT(toFcl(system).text, HasSubstr(" WITH 1.0e-05;"));
}

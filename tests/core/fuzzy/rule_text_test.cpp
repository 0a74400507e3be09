#include "core/fuzzy/rule_text.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

FuzzySystem ageAndZeal() {
    FuzzySystem system;
    system.inputs = {{"age", 0, 9, {{"young", {0, 0, 2, 4}}, {"old", {4, 9, 9, 9}}}},
                     {"zeal", 0, 1, {{"much", {0.5, 1, 1, 1}}}}};
    system.outputs = {{"viscosity", 0, 5, {{"thin", {0, 0, 1, 2}}, {"thick", {3, 4, 5, 5}}}}};
    return system;
}

/// How a rule reads once it was read; or why it cannot be.
std::string reread(const std::string& rule) {
    try {
        const FuzzySystem system = ageAndZeal();
        return ruleText(system, parseRule(system, rule));
    } catch (const RuleError& error) {
        return error.what();
    }
}

RuleMistake mistakeIn(const std::string& rule) {
    try {
        parseRule(ageAndZeal(), rule);
    } catch (const RuleError& error) {
        return error.mistake();
    }
    ADD_FAILURE() << "accepted: " << rule;
    return {};
}

/// The same of a condition alone.
std::string rereadCondition(const std::string& condition) {
    const std::string text = reread("IF " + condition + " THEN viscosity IS thin");
    const std::size_t then = text.rfind(" THEN ");
    return then == std::string::npos ? text : text.substr(3, then - 3);
}

std::string repeated(const std::string& text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i)
        result += text;
    return result;
}

} // namespace

TEST(Rule, IsWrittenAsItIsRead) {
    for (const char* text :
         {"IF age IS old AND zeal IS much THEN viscosity IS thick",
          "IF zeal IS much THEN viscosity IS thin AND viscosity IS thick",
          "IF zeal IS NOT much OR age IS old AND age IS young THEN viscosity IS thin WITH 0.5",
          "IF NOT (age IS old OR zeal IS much) THEN viscosity IS thick WITH 0",
          "IF age IS old THEN viscosity IS thick WITH 0.30000000000000004",
          "IF age IS old THEN viscosity IS thick WITH 1.0e-09"})
        EXPECT_EQ(reread(text), text);
    EXPECT_EQ(reread("  if age\tis old And zeal iS nOT much\nthen viscosity Is thick With 0.5 "),
              "IF age IS old AND zeal IS NOT much THEN viscosity IS thick WITH 0.5");
    EXPECT_EQ(reread("IF age IS old THEN viscosity IS thick WITH 1.0"),
              "IF age IS old THEN viscosity IS thick");
}

TEST(Rule, BindsNotTighterThanAndAndAndTighterThanOr) {
    using Kind = FuzzyCondition::Kind;
    const FuzzyCondition condition =
        parseRule(ageAndZeal(), "IF NOT age IS old AND zeal IS much OR age IS young THEN viscosity IS thin")
            .condition;
    ASSERT_EQ(condition.kind, Kind::Or);
    ASSERT_EQ(condition.parts.size(), 2);
    EXPECT_EQ(condition.parts[1].kind, Kind::Is);
    const FuzzyCondition& both = condition.parts[0];
    ASSERT_EQ(both.kind, Kind::And);
    ASSERT_EQ(both.parts.size(), 2);
    EXPECT_EQ(both.parts[0].kind, Kind::Not);
    EXPECT_EQ(both.parts[0].parts.at(0).proposition.term, 1);
    EXPECT_EQ(both.parts[1].proposition.variable, 1);
}

TEST(Rule, HasAsFewBracketsAsItCan) {
    EXPECT_EQ(rereadCondition("((age IS old)) AND (zeal IS much)"), "age IS old AND zeal IS much");
    EXPECT_EQ(rereadCondition("(age IS old AND zeal IS much) OR (age IS young)"),
              "age IS old AND zeal IS much OR age IS young");
    EXPECT_EQ(rereadCondition("age IS old AND (zeal IS much AND (age IS young))"),
              "age IS old AND zeal IS much AND age IS young");
    EXPECT_EQ(rereadCondition("age IS old OR (zeal IS much OR age IS young)"),
              "age IS old OR zeal IS much OR age IS young");
    EXPECT_EQ(rereadCondition("(age IS old OR zeal IS much)AND(age IS young)"),
              "(age IS old OR zeal IS much) AND age IS young");
    EXPECT_EQ(rereadCondition("NOT(zeal IS much)"), "zeal IS NOT much");
    EXPECT_EQ(rereadCondition("NOT NOT zeal IS much"), "NOT zeal IS NOT much");
    EXPECT_EQ(rereadCondition("NOT (NOT (age IS old AND zeal IS much))"),
              "NOT NOT (age IS old AND zeal IS much)");
}

TEST(Rule, ThatCannotBeReadSaysWhereAndWhatWasExpected) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"", "column 1: expected IF, but the rule ends"},
        {"age IS old", "column 1: expected IF, but found \"age\""},
        {"IF ages IS old THEN viscosity IS thin",
         "column 4: expected NOT, \"(\" or the name of an input (age, zeal), but found \"ages\""},
        {"IF THEN viscosity IS thin",
         "column 4: expected NOT, \"(\" or the name of an input (age, zeal), but found \"THEN\""},
        {"IF age IS ancient THEN viscosity IS thin",
         "column 11: expected NOT or the name of a term of age (young, old), but found \"ancient\""},
        {"IF age IS NOT NOT old THEN viscosity IS thin",
         "column 15: expected the name of a term of age (young, old), but found \"NOT\""},
        {"IF age old THEN viscosity IS thin", "column 8: expected IS, but found \"old\""},
        {"IF age IS old zeal IS much THEN viscosity IS thin",
         "column 15: expected AND, OR or THEN, but found \"zeal\""},
        {"IF age IS old", "column 14: expected AND, OR or THEN, but the rule ends"},
        {"IF age IS old) THEN viscosity IS thin", "column 14: expected AND, OR or THEN, but found \")\""},
        {"IF (age IS old THEN viscosity IS thin", "column 16: expected AND, OR or \")\", but found \"THEN\""},
        {"IF () THEN viscosity IS thin",
         "column 5: expected NOT, \"(\" or the name of an input (age, zeal), but found \")\""},
        {"IF age IS old AND OR zeal IS much THEN viscosity IS thin",
         "column 19: expected NOT, \"(\" or the name of an input (age, zeal), but found \"OR\""},
        {"IF age IS old THEN age IS old",
         "column 20: expected the name of an output (viscosity), but found \"age\""},
        {"IF age IS old THEN viscosity IS NOT thin",
         "column 33: expected the name of a term of viscosity (thin, thick), but found \"NOT\""},
        {"IF age IS old THEN viscosity IS thin OR viscosity IS thick",
         "column 38: expected AND, WITH or the end of the rule, but found \"OR\""},
        {"IF age IS old THEN viscosity IS thin ELSE",
         "column 38: expected AND, WITH or the end of the rule, but found \"ELSE\""},
        {"IF age IS old THEN viscosity IS thin WITH",
         "column 42: expected a weight from 0 to 1, but the rule ends"},
        {"IF age IS old THEN viscosity IS thin WITH 1.5",
         "column 43: expected a weight from 0 to 1, but found \"1.5\""},
        {"IF age IS old THEN viscosity IS thin WITH -0.5",
         "column 43: expected a weight from 0 to 1, but found \"-0.5\""},
        {"IF age IS old THEN viscosity IS thin WITH nan",
         "column 43: expected a weight from 0 to 1, but found \"nan\""},
        {"IF age IS old THEN viscosity IS thin WITH 0,5",
         "column 43: expected a weight from 0 to 1, but found \"0,5\""},
        {"IF age IS old THEN viscosity IS thin WITH 0.5 AND viscosity IS thick",
         "column 47: expected the end of the rule, but found \"AND\""},
        {"IF Gr\xC3\xB6\xC3\x9F"
         "e IS old",
         "column 4: expected NOT, \"(\" or the name of an input (age, zeal), but found \"Gr\xC3\xB6\xC3\x9F"
         "e\""},
        {"IF age \xC3\xB6 old", "column 8: expected IS, but found \"\xC3\xB6\""},
        {"IF age IS \xC3\xB6\xC3\xB6 THEN", "column 11: expected NOT or the name of a term of age (young, "
                                            "old), but found \"\xC3\xB6\xC3\xB6\""}};
    for (const auto& [rule, complaint] : cases)
        EXPECT_EQ(reread(rule), complaint);
}

TEST(Rule, ThatCannotBeReadTellsWhatToUnderlineAndWhatToOffer) {
    const auto expectMistake = [](const std::string& rule, std::size_t column, std::size_t length,
                                  const std::vector<std::string>& alternatives) {
        const RuleMistake mistake = mistakeIn(rule);
        EXPECT_EQ(mistake.column, column) << rule;
        EXPECT_EQ(mistake.length, length) << rule;
        EXPECT_THAT(mistake.alternatives, testing::UnorderedElementsAreArray(alternatives)) << rule;
    };
    expectMistake("IF \xC3\xB6\xC3\xB6 IS old", 4, 2, {"NOT", "(", "age", "zeal"});
    expectMistake("IF age IS o THEN", 11, 1, {"NOT", "young", "old"});
    expectMistake("IF (age IS old th", 16, 2, {"AND", "OR", ")"});
    expectMistake("IF age IS old ", 15, 0, {"AND", "OR", "THEN"});
    expectMistake("IF age IS old THEN viscosity IS thin W", 38, 1, {"AND", "WITH"});
    expectMistake("IF age IS old THEN viscosity IS thin WITH two", 43, 3, {});
}

TEST(Rule, ThatCannotBeReadSaysItWithoutTheColumnAsWell) {
    try {
        parseRule(ageAndZeal(), "IF age: IS old");
        FAIL() << "accepted";
    } catch (const RuleError& error) {
        EXPECT_EQ("column 4: " + error.problem(), error.what());
    }
}

TEST(Rule, NestedWithoutEndIsRefusedAtItsPlace) {
    const std::string leaf = "age IS old", end = " THEN viscosity IS thin";
    EXPECT_EQ(reread("IF " + repeated("(", 10000) + leaf + repeated(")", 10000) + end),
              "column 104: brackets and NOT are nested deeper than 100");
    EXPECT_EQ(reread("IF " + repeated("NOT ", 10000) + leaf + end),
              "column 404: brackets and NOT are nested deeper than 100");
    EXPECT_EQ(reread("IF " + repeated("(", 10000)),
              "column 104: brackets and NOT are nested deeper than 100");
    EXPECT_EQ(
        reread("IF " + repeated("age IS old OR zeal IS much AND (", 60) + leaf + repeated(")", 60) + end),
        "column 4: brackets and NOT are nested deeper than 100");
    // What may be, comes back.
    const std::string deep =
        repeated("age IS old OR zeal IS much AND (", 49) + leaf + " OR zeal IS much" + repeated(")", 49);
    EXPECT_EQ(rereadCondition(deep), deep);
    const std::string negated = repeated("NOT ", 98) + "age IS NOT old";
    EXPECT_EQ(rereadCondition(negated), negated);
}

TEST(Rule, MayBeLong) {
    const std::string condition = repeated("age IS old AND zeal IS much OR ", 20000) + "age IS young";
    EXPECT_EQ(rereadCondition(condition), condition);
}

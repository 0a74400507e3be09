#include "core/fuzzy/rule_lines.h"

#include "tests/core/fuzzy/age_and_zeal.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RuleLines, AreReadAsTheyAreWritten) {
    const FuzzySystem system = ageAndZealSystem(
        {"IF age IS old THEN viscosity IS thick", "IF zeal IS NOT much THEN mass IS small WITH 0.5"});
    EXPECT_EQ(rulesText(system), "IF age IS old THEN viscosity IS thick\n"
                                 "IF zeal IS NOT much THEN mass IS small WITH 0.5");
    FuzzySystem reread = ageAndZealSystem();
    const RulesReading reading = readRules(reread, {"if age is old then viscosity is thick", " \t", "",
                                                    "IF zeal IS NOT much THEN mass IS small WITH .5", ""});
    EXPECT_THAT(reading.unread, IsEmpty());
    reread.rules = reading.rules;
    EXPECT_EQ(rulesText(reread), rulesText(system));
}

TEST(RuleLines, ThatCannotBeReadAreNumberedAsRulesAndAsLines) {
    const RulesReading reading =
        readRules(ageAndZealSystem(), {"", "IF age IS old THEN mass IS small", "", "IF age IS old",
                                       "IF age IS older THEN mass IS small"});
    EXPECT_EQ(reading.rules.size(), 1u);
    ASSERT_EQ(reading.unread.size(), 2u);
    EXPECT_EQ(reading.unread[0].line, 3u);
    EXPECT_EQ(reading.unread[0].number, 2u);
    EXPECT_THAT(reading.unread[0].message, HasSubstr("expected AND, OR or THEN"));
    EXPECT_EQ(reading.unread[1].line, 4u);
    EXPECT_EQ(reading.unread[1].number, 3u);
    EXPECT_EQ(reading.unread[1].mistake.column, 11u);
    EXPECT_EQ(reading.unread[1].mistake.length, 5u);
}

TEST(RuleLines, TooManyAreOneProblem) {
    const RulesReading reading = readRules(ageAndZealSystem(), std::vector<std::string>(10000, "IF"));
    EXPECT_THAT(reading.problem, HasSubstr("10000"));
    EXPECT_THAT(reading.problem, HasSubstr("2000"));
    EXPECT_THAT(reading.rules, IsEmpty());
    EXPECT_THAT(reading.unread, IsEmpty());
}

TEST(WordsThatFit, FollowWhatWasWritten) {
    const FuzzySystem system = ageAndZealSystem();
    EXPECT_THAT(wordsThatFit(system, ""), ElementsAre("IF"));
    EXPECT_THAT(wordsThatFit(system, "IF "), testing::UnorderedElementsAre("age", "zeal", "NOT", "("));
    EXPECT_THAT(wordsThatFit(system, "IF age "), ElementsAre("IS"));
    EXPECT_THAT(wordsThatFit(system, "IF age IS"), testing::UnorderedElementsAre("young", "old", "NOT"));
    EXPECT_THAT(wordsThatFit(system, "if (age is old "), testing::UnorderedElementsAre("AND", "OR", ")"));
    EXPECT_THAT(wordsThatFit(system, "IF age IS old THEN "), ElementsAre("viscosity", "mass"));
    EXPECT_THAT(wordsThatFit(system, "IF age IS old THEN mass IS small "), ElementsAre("AND", "WITH"));
    EXPECT_THAT(wordsThatFit(system, "IF age IS older "), IsEmpty());
    EXPECT_THAT(wordsThatFit(system, "IF age IS old THEN mass IS small WITH "), IsEmpty());
}

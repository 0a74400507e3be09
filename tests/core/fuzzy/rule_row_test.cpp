#include "core/fuzzy/rule_row.h"

#include "tests/core/fuzzy/age_and_zeal.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

std::string rewritten(const std::string& line) {
    const FuzzySystem system = ageAndZealSystem();
    return lineOf(system, rowOf(system, line));
}

} // namespace

TEST(RuleRow, ShowsPlainRulesInCells) {
    const FuzzySystem system = ageAndZealSystem();
    const RuleRow row = rowOf(system, "IF zeal IS NOT much AND age IS old THEN viscosity IS thick WITH 0.25");
    ASSERT_TRUE(row.inputs[0] && row.inputs[1]);
    EXPECT_EQ(row.inputs[0]->term, 1u);
    EXPECT_FALSE(row.inputs[0]->isNegated);
    EXPECT_TRUE(row.inputs[1]->isNegated);
    EXPECT_EQ(row.outputs[0], std::optional<std::size_t>(1));
    EXPECT_FALSE(row.outputs[1]);
    EXPECT_EQ(row.weight, 0.25);
    EXPECT_EQ(row.condition + row.conclusions + row.unread, "");
    EXPECT_EQ(lineOf(system, row), "IF age IS old AND zeal IS NOT much THEN viscosity IS thick WITH 0.25");
}

TEST(RuleRow, KeepsAsTextWhatCellsCannotShow) {
    const FuzzySystem system = ageAndZealSystem();
    for (const char* condition : {"age IS old OR zeal IS much", "NOT (age IS old AND zeal IS much)",
                                  "age IS NOT old AND age IS NOT young"}) {
        const RuleRow row = rowOf(system, std::string("IF ") + condition + " THEN mass IS small");
        EXPECT_EQ(row.condition, condition);
        EXPECT_FALSE(row.inputs[0] || row.inputs[1]);
        EXPECT_EQ(row.outputs[1], std::optional<std::size_t>(0));
        EXPECT_EQ(lineOf(system, row), std::string("IF ") + condition + " THEN mass IS small");
    }
    const RuleRow both = rowOf(system, "IF age IS old THEN viscosity IS thin AND viscosity IS thick");
    EXPECT_EQ(both.conclusions, "viscosity IS thin AND viscosity IS thick");
    EXPECT_TRUE(both.inputs[0]);
}

TEST(RuleRow, MayBeUnfinished) {
    const FuzzySystem system = ageAndZealSystem();
    for (const char* line : {"IF THEN", "IF THEN mass IS small", "IF age IS old AND zeal IS much THEN",
                             "IF age IS old THEN WITH 0.5", "IF age IS old OR zeal IS much THEN"}) {
        const RuleRow row = rowOf(system, line);
        EXPECT_EQ(row.unread, "");
        EXPECT_EQ(lineOf(system, row), line);
    }
    const RuleRow bracketed = rowOf(system, "IF(age IS old OR zeal IS much) THEN");
    EXPECT_EQ(bracketed.unread, "");
    EXPECT_EQ(lineOf(system, bracketed), "IF age IS old OR zeal IS much THEN");
    EXPECT_EQ(rewritten("IF (age IS old)THEN WITH 0.5"), "IF age IS old THEN WITH 0.5");
    EXPECT_FALSE(rowOf(system, "IF THEN mass IS small").inputs[0]);
    EXPECT_FALSE(rowOf(system, "IF age IS old THEN").outputs[0]);
}

TEST(RuleRow, LeavesALineThatIsNoRuleAsItIs) {
    for (const char* line :
         {"IF age IS older THEN mass IS small", "IF age IS old", "hello", "IF THEN THEN",
          "IF age IS old THEN mass IS small WITH", "IF THEN mass IS", "IF AND THEN mass IS small",
          "IF age IS old THEN WITH 2", "IF THEN mass IS small WITH"})
        EXPECT_EQ(rewritten(line), line) << rowOf(ageAndZealSystem(), line).weight;
    EXPECT_EQ(rowOf(ageAndZealSystem(), "hello").unread, "hello");
    EXPECT_EQ(rowOf(ageAndZealSystem(), "IF THEN mass IS small WITH").unread, "IF THEN mass IS small WITH");
}

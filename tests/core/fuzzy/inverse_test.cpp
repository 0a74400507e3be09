#include "core/fuzzy/inverse.h"

#include "core/exchange/fuzzy/fuzzy_file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm {
namespace {

TEST(Inverse, FindsTheInputAtWhichAnOutputIsWhatIsWanted) {
    const FuzzySystem system = fuzzyPreset("organ");
    for (const double firmness : {0.0, 0.4, 3.14159, 5.0, 8.0001, 10.0})
        for (const double springiness : {0.0, 7.3, 10.0}) {
            const auto outputs = infer(system, {firmness, springiness}).outputs;
            const auto modulus = reachingInput(system, {5, 5}, 0, *outputs[0]);
            const auto time = reachingInput(system, {5, 5}, 1, *outputs[1]);
            ASSERT_TRUE(modulus && time) << firmness << ' ' << springiness;
            EXPECT_EQ(modulus->input, 0U);
            EXPECT_NEAR(modulus->value, firmness, 1e-5);
            EXPECT_EQ(time->input, 1U);
            EXPECT_NEAR(time->value, springiness, 1e-5);
        }
}

TEST(Inverse, FindsNothingBeyondWhatTheWordsReach) {
    const FuzzySystem system = fuzzyPreset("organ");
    EXPECT_FALSE(reachingInput(system, {5, 5}, 0, 1e6));
    EXPECT_FALSE(reachingInput(system, {5, 5}, 0, 100));
}

/// Of the published system the spring constant falls between "medium" and "wobbly".
TEST(Inverse, TakesTheLeastOfSeveralPlaces) {
    const FuzzySystem system = fuzzyPreset("susilap-g");
    const auto reached = reachingInput(system, {5}, 0, 20);
    ASSERT_TRUE(reached);
    EXPECT_NEAR(*infer(system, {reached->value}).outputs[0], 20, 1e-4);
    for (double before = 0; before < reached->value - 0.02; before += 0.01)
        EXPECT_LT(infer(system, {before}).outputs[0].value_or(0), 20) << before;
}

/// Two words that do not overlap: between their figures lies a jump.
TEST(Inverse, TakesNoJumpForTheValue) {
    FuzzySystem system;
    system.name = "steps";
    system.inputs = {{"firmness", 0, 10, {{"low", {0, 0, 5, 5}}, {"high", {5, 5, 10, 10}}}}};
    system.outputs = {{"mass", 0, 10, {{"small", {1, 1, 1, 1}}, {"large", {9, 9, 9, 9}}}}};
    for (std::size_t term = 0; term < 2; ++term) {
        FuzzyRule rule;
        rule.condition = {{0, term}};
        rule.conclusions = {{0, term}};
        system.rules.push_back(rule);
    }
    EXPECT_FALSE(reachingInput(system, {2}, 0, 4));
    EXPECT_TRUE(reachingInput(system, {2}, 0, 9));
}

} // namespace
} // namespace esm

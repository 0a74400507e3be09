#include "core/fuzzy/output_response.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/inference.h"
#include "tests/core/fuzzy/random_systems.h"
#include "tests/support/rounds.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;

namespace {

/// One input from 0 to 10, one output from 0 to 100, a rule for each pair of terms.
FuzzySystem bridge(const std::vector<Trapezoid>& inputs, const std::vector<Trapezoid>& outputs) {
    FuzzySystem system;
    system.inputs = {{"x", 0, 10, {}}};
    system.outputs = {{"y", 0, 100, {}}};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        system.inputs[0].terms.push_back({"t" + std::to_string(i), inputs[i]});
        system.outputs[0].terms.push_back({"t" + std::to_string(i), outputs[i]});
        system.rules.push_back({{{0, i}}, {{0, i}}});
    }
    return system;
}

ResponseCurve curveOf(const FuzzySystem& system) {
    return responseCurve(system, {0, {std::nullopt}}, 0);
}

} // namespace

TEST(ResponseCurve, AgreesWithTheInferenceOfRandomSystems) {
    RandomSystems systems(seedOf(5));
    std::size_t points = 0;
    for (int trial = 0; trial < roundsOf(40, 4000); ++trial) {
        const FuzzySystem system = systems.next();
        const std::vector<double> values = systems.inputs(system);
        const ResponseQuestion question{system.outputs.size() - 1, {values.begin(), values.end()}};
        const double most = 0.01 * (system.outputs.back().maximum - system.outputs.back().minimum);
        for (const auto& piece : responseCurve(system, question, 0)) {
            std::optional<double> before;
            for (const auto [x, y] : piece) {
                auto inputs = question.inputs;
                inputs[0] = x;
                ASSERT_EQ(infer(system, inputs).outputs.back(), y) << trial;
                if (before) {
                    EXPECT_LE(std::abs(y - *before), most) << trial;
                }
                before = y;
                ++points;
            }
        }
    }
    EXPECT_GT(points, 2000U);
}

TEST(ResponseCurve, HasGapsWhereNoRuleReaches) {
    const ResponseCurve curve =
        curveOf(bridge({{0, 0, 2, 3}, {6, 7, 10, 10}}, {{0, 10, 10, 20}, {60, 70, 70, 80}}));
    ASSERT_EQ(curve.size(), 2U);
    EXPECT_EQ(curve[0].front().input, 0);
    EXPECT_NEAR(curve[0].back().input, 3, 1e-7);
    EXPECT_NEAR(curve[1].front().input, 6, 1e-7);
    EXPECT_EQ(curve[1].back().input, 10);
    EXPECT_NEAR(curve[1].front().output, 70, 1e-9);
    EXPECT_TRUE(curveOf(bridge({{11, 12, 12, 13}}, {{0, 10, 10, 20}})).empty());
}

TEST(ResponseCurve, FindsGapsThatBeginBetweenCorners) {
    // Both above a half together: 1 − x/10 and x/5 give more than 1 from x = 0 on, up to 5, then 1 − x/10.
    FuzzySystem system = bridge({{-10, 0, 0, 10}, {0, 8, 8, 8}}, {{0, 10, 10, 20}, {0, 10, 10, 20}});
    system.norms.conjunction = TNorm::BoundedDifference;
    system.rules = {{conjunction({{{0, 0}}, {{0, 0}}}), {{0, 0}}}}; // 2 (1 − x/10) − 1 > 0 up to 5
    const ResponseCurve curve = curveOf(system);
    ASSERT_EQ(curve.size(), 1U);
    EXPECT_NEAR(curve[0].back().input, 5, 1e-6);
}

TEST(ResponseCurve, BreaksWhereTheOutputJumps) {
    // Terms that meet at 5 without overlap: both hold there.
    const ResponseCurve curve =
        curveOf(bridge({{0, 0, 5, 5}, {5, 5, 10, 10}}, {{0, 10, 10, 20}, {60, 70, 70, 80}}));
    ASSERT_EQ(curve.size(), 3U);
    EXPECT_NEAR(curve[0].back().input, 5, 1e-7);
    EXPECT_NEAR(curve[0].back().output, 10, 1e-9);
    ASSERT_EQ(curve[1].size(), 1U);
    EXPECT_NEAR(curve[1][0].output, 40, 1e-9);
    EXPECT_NEAR(curve[2].front().output, 70, 1e-9);
}

TEST(ResponseCurve, BreaksAtCornersHoweverManyThereAre) {
    constexpr std::size_t count = 2000; // 6000 points are fewer than those beside their corners
    std::vector<Trapezoid> inputs, outputs;
    const auto corner = [](std::size_t i) { return 10.0 * static_cast<double>(i) / count; };
    for (std::size_t i = 0; i < count; ++i) {
        inputs.push_back({corner(i), corner(i), corner(i + 1), corner(i + 1)});
        outputs.push_back(i % 2 ? Trapezoid{60, 70, 70, 80} : Trapezoid{0, 10, 10, 20});
    }
    const ResponseCurve curve = curveOf(bridge(inputs, outputs));
    EXPECT_EQ(curve.size(), count + count - 1) << "terms, and the corners between two of them";
    for (const auto& piece : curve)
        for (const ResponsePoint& point : piece)
            ASSERT_NEAR(point.output, piece.front().output, 1e-9) << point.input;
}

TEST(ResponseCurve, SeesTermsNarrowerThanItsSteps) {
    const ResponseCurve curve = curveOf(
        bridge({{0, 0, 10, 10}, {3.3331, 3.3332, 3.3333, 3.3334}}, {{0, 10, 10, 20}, {60, 70, 70, 80}}));
    ASSERT_EQ(curve.size(), 1U);
    double highest = 0;
    for (const ResponsePoint& point : curve[0])
        highest = std::max(highest, point.output);
    EXPECT_NEAR(highest, 40, 1e-9);
}

TEST(ResponseCurve, CanBeCancelled) {
    const FuzzySystem system = fuzzyPreset("susilap-g");
    EXPECT_THROW(responseCurve(system, {0, {5.5}}, 0, [](double) { return false; }), Cancelled);
    const FuzzySystem three = fuzzyPreset("robo-sim");
    int left = 100;
    EXPECT_THROW(responseMap(three, {0, {5.0, 5.0, 5.0}}, {0, 1}, 64, [&](double) { return --left > 0; }),
                 Cancelled);
    EXPECT_EQ(left, 0);
}

TEST(ResponseMap, HoldsWhatIsInferredInTheMiddleOfEachCell) {
    FuzzySystem system = fuzzyPreset("robo-sim");
    system.rules.erase(system.rules.begin(), system.rules.begin() + 8); // gaps
    const ResponseQuestion question{1, {7.3, std::nullopt, 3.0}};
    const MapInputs inputs{2, 1};
    const ResponseMap map = responseMap(system, question, inputs, 20);
    ASSERT_EQ(map.values.size(), 400U);
    for (std::size_t row = 0; row < 20; ++row)
        for (std::size_t column = 0; column < 20; ++column) {
            const std::vector<std::optional<double>> values{7.3, 10 * (double(row) + 0.5) / 20,
                                                            10 * (double(column) + 0.5) / 20};
            EXPECT_EQ(map.at(column, row), infer(system, values).outputs[1]) << column << ' ' << row;
        }
}

TEST(UsualValues, AreThoseOfTheTermsThatAreConcluded) {
    FuzzySystem system = bridge({{0, 0, 5, 5}, {5, 5, 10, 10}}, {{10, 20, 20, 30}, {60, 70, 70, 80}});
    system.outputs[0].terms.push_back({"unused", {90, 100, 100, 100}});
    const auto [low, high] = usualValues(system, 0);
    EXPECT_NEAR(low, 20, 1e-9);
    EXPECT_NEAR(high, 70, 1e-9);
    system.rules.clear();
    EXPECT_EQ(usualValues(system, 0), std::make_pair(0.0, 100.0));
}

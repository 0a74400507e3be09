#include "core/fuzzy/explanation.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "tests/core/fuzzy/degree_system.h"
#include "tests/core/fuzzy/random_systems.h"
#include "tests/support/rounds.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

using namespace esm;
using testing::DoubleEq;
using testing::ElementsAre;

namespace esm {

bool operator==(const OutlinePoint& one, const OutlinePoint& other) {
    return one.x == other.x && one.degree == other.degree;
}

} // namespace esm

namespace {

std::vector<double> firingOf(const std::vector<RuleExplanation>& rules) {
    std::vector<double> firing;
    for (const RuleExplanation& rule : rules)
        firing.push_back(rule.firing);
    return firing;
}

OutputExplanation explained(const FuzzySystem& system, std::size_t output = 0) {
    const std::vector<std::optional<double>> zeros(system.inputs.size(), 0.0);
    return explainOutput(system, output, infer(system, zeros).firing);
}

/// Of the area beneath an outline.
double centreBeneath(const Outline& outline) {
    double area = 0, moment = 0;
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const auto [x, degree] = outline[i - 1];
        const double width = outline[i].x - x, next = outline[i].degree;
        area += 0.5 * width * (degree + next);
        moment += 0.5 * width * (degree + next) * x + width * width * (degree + 2 * next) / 6;
    }
    return moment / area;
}

double degreeAt(const Outline& outline, double x) {
    const auto right = std::find_if(outline.begin() + 1, outline.end(),
                                    [&](const OutlinePoint& point) { return point.x >= x; });
    const auto left = right - 1;
    if (right->x == left->x) return std::max(left->degree, right->degree);
    return left->degree + (x - left->x) / (right->x - left->x) * (right->degree - left->degree);
}

} // namespace

TEST(ExplainRules, TellsTheDegreeOfEveryWord) {
    const FuzzySystem system = fuzzyPreset("robo-sim");
    const std::vector<std::optional<double>> inputs{7.3, 4.9, std::nullopt};
    const std::vector<RuleExplanation> rules = explainRules(system, inputs);
    EXPECT_EQ(firingOf(rules), infer(system, inputs).firing);
    ASSERT_EQ(rules[1].propositions.size(), 1); // IF consistency IS hard
    EXPECT_EQ(rules[1].propositions[0].proposition.variable, 0);
    EXPECT_EQ(system.inputs[0].terms[rules[1].propositions[0].proposition.term].name, "hard");
    EXPECT_DOUBLE_EQ(rules[1].propositions[0].degree.value(), 0.8);
    EXPECT_DOUBLE_EQ(rules[1].condition.value(), 0.8);
    EXPECT_EQ(rules[11].condition, std::nullopt) << "asks for shiftability";
    EXPECT_EQ(rules[11].propositions[0].degree, std::nullopt);
    EXPECT_EQ(rules[11].firing, 0);
}

TEST(ExplainRules, GoesIntoBracketsAndKeepsTheWeightApart) {
    FuzzySystem system = degreeSystem({{0, 1, 1, 2}, {0, 1, 1, 2}, {0, 1, 1, 2}}, {0.75, 0.5, 0.25});
    system.rules = {{disjunction({negation({{0, 0}}), conjunction({{{1, 0}}, {{2, 0}}})}), {{0, 0}}, 0.5}};
    const RuleExplanation rule = explainRules(system, {0.0, 0.0, 0.0}).at(0);
    ASSERT_EQ(rule.propositions.size(), 3);
    EXPECT_EQ(rule.propositions[0].degree, 0.75) << "before the NOT";
    EXPECT_EQ(rule.propositions[2].degree, 0.25);
    EXPECT_EQ(rule.condition, 0.25);
    EXPECT_EQ(rule.firing, 0.125);
}

TEST(ExplainOutput, OutlinesWhatEachRuleConcludes) {
    FuzzySystem system = degreeSystem({{0, 2, 4, 6}, {95, 98, 120, 120}}, {0.5, 1});
    const OutputExplanation clipped = explained(system);
    ASSERT_EQ(clipped.sets.size(), 2);
    EXPECT_EQ(clipped.sets[1].rule, 1);
    EXPECT_EQ(clipped.sets[1].term, 1);
    EXPECT_THAT(clipped.sets[0].outline, ElementsAre(OutlinePoint{0, 0}, OutlinePoint{1, 0.5},
                                                     OutlinePoint{5, 0.5}, OutlinePoint{6, 0}));
    EXPECT_THAT(clipped.sets[1].outline, ElementsAre(OutlinePoint{95, 0}, OutlinePoint{98, 1},
                                                     OutlinePoint{100, 1}, OutlinePoint{100, 0}));
    EXPECT_THAT(clipped.aggregated,
                ElementsAre(OutlinePoint{-100, 0}, OutlinePoint{0, 0}, OutlinePoint{1, 0.5},
                            OutlinePoint{5, 0.5}, OutlinePoint{6, 0}, OutlinePoint{95, 0},
                            OutlinePoint{98, 1}, OutlinePoint{100, 1}, OutlinePoint{100, 0}));
    system.norms.implication = TNorm::Product;
    EXPECT_THAT(explained(system).sets[0].outline, ElementsAre(OutlinePoint{0, 0}, OutlinePoint{2, 0.5},
                                                               OutlinePoint{4, 0.5}, OutlinePoint{6, 0}));
}

TEST(ExplainOutput, StandsPointsUpAsLines) {
    const OutputExplanation points = explained(degreeSystem({{4, 4, 4, 4}, {10, 10, 10, 10}}, {0.75, 0.25}));
    EXPECT_THAT(points.sets[0].outline,
                ElementsAre(OutlinePoint{4, 0}, OutlinePoint{4, 0.75}, OutlinePoint{4, 0}));
    EXPECT_THAT(points.aggregated,
                ElementsAre(OutlinePoint{-100, 0}, OutlinePoint{4, 0}, OutlinePoint{4, 0.75},
                            OutlinePoint{4, 0}, OutlinePoint{10, 0}, OutlinePoint{10, 0.25},
                            OutlinePoint{10, 0}, OutlinePoint{100, 0}));
    EXPECT_EQ(points.value, 5.5);
}

TEST(ExplainOutput, HasNothingToShowWhereNoRuleFires) {
    const OutputExplanation none = explained(degreeSystem({{0, 1, 1, 2}}, {0}));
    EXPECT_TRUE(none.sets.empty());
    EXPECT_EQ(none.value, std::nullopt);
    EXPECT_THAT(none.aggregated, ElementsAre(OutlinePoint{-100, 0}, OutlinePoint{100, 0}));
}

// In doubles -3.7 + (3.9 - -3.7) is less than 3.9: parts that end there would leave a gap, which falls to 0.
TEST(ExplainOutput, DrawsSetsThatRiseTogetherWithoutAGap) {
    FuzzySystem system = degreeSystem({{-3.7, 9, 10, 20}, {-3.7, 9, 10, 20}, {3.9, 9, 10, 20}}, {1, 1, 1});
    system.norms.aggregation = TConorm::ProbabilisticSum;
    for (const OutlinePoint& point : explained(system).aggregated)
        if (point.x > -3.6 && point.x < 19) {
            EXPECT_GT(point.degree, 0) << "at " << point.x;
        }
}

TEST(ExplainOutput, AgreesWithTheInferenceOfRandomSystems) {
    RandomSystems systems(seedOf(11));
    int compared = 0;
    for (int trial = 0; trial < roundsOf(300, 30000); ++trial) {
        const FuzzySystem system = systems.next();
        const std::vector<double> values = systems.inputs(system);
        const InferenceResult result = infer(system, {values.begin(), values.end()});
        for (std::size_t i = 0; i < system.outputs.size(); ++i) {
            const OutputExplanation explanation = explainOutput(system, i, result.firing);
            ASSERT_EQ(explanation.value, result.outputs[i]) << trial;
            if (!explanation.value) continue;
            // The curved sum is drawn by chords.
            const bool isCurved = system.norms.aggregation == TConorm::ProbabilisticSum;
            const double range = system.outputs[i].maximum - system.outputs[i].minimum;
            EXPECT_NEAR(centreBeneath(explanation.aggregated), *explanation.value,
                        (isCurved ? 1e-3 : 1e-9) * range)
                << trial;
            for (const ConcludedSet& set : explanation.sets)
                for (const auto [x, degree] : set.outline)
                    EXPECT_GE(degreeAt(explanation.aggregated, x), degree - 1e-9) << trial;
            ++compared;
        }
    }
    EXPECT_GT(compared, 200);
}

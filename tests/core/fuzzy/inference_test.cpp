#include "core/fuzzy/inference.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/support/errors.h"
#include "tests/core/fuzzy/degree_system.h"
#include "tests/support/shared_data.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::optional<double> centre(const std::vector<Trapezoid>& outputs, const std::vector<double>& degrees) {
    return centreOf(degreeSystem(outputs, degrees));
}

/// Independent witness: the definition itself, max over sets of min(degree, membership), summed in small
/// cells.
long double bruteCentre(const std::vector<Trapezoid>& sets, const std::vector<double>& degrees, double low,
                        double high) {
    const auto value = [&](long double x) {
        long double highest = 0;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const Trapezoid& s = sets[i];
            long double m = 0;
            if (x >= s.a && x <= s.d) {
                m = 1;
                if (x < s.b) m = (x - s.a) / (static_cast<long double>(s.b) - s.a);
                if (x > s.c) m = (s.d - x) / (static_cast<long double>(s.d) - s.c);
            }
            highest = std::max(highest, std::min<long double>(degrees[i], m));
        }
        return highest;
    };
    constexpr int cells = 200000;
    const long double width = (static_cast<long double>(high) - low) / cells;
    long double area = 0, moment = 0;
    for (int i = 0; i < cells; ++i) {
        const long double x = low + (i + 0.5L) * width;
        area += value(x);
        moment += value(x) * x;
    }
    return moment / area;
}

struct Sample {
    std::size_t line;
    std::vector<double> numbers;
};

std::vector<Sample> readSamples(const std::filesystem::path& file, std::size_t columns) {
    std::ifstream stream(file);
    std::vector<Sample> samples;
    std::string line;
    std::getline(stream, line);
    for (std::size_t number = 2; std::getline(stream, line); ++number) {
        Sample sample{number, {}};
        std::istringstream cells(line);
        for (std::string cell; sample.numbers.size() < columns && std::getline(cells, cell, ',');)
            sample.numbers.push_back(std::stod(cell));
        samples.push_back(sample);
    }
    return samples;
}

/// Compares all samples of one system.
void expectSamples(const std::string& name) {
    const std::filesystem::path file = sharedData("fuzzy/" + name + ".csv");
    ESM_SKIP_WITHOUT(file);
    const FuzzySystem system = fuzzyPreset(name);
    const std::size_t inputs = system.inputs.size();
    const std::vector<Sample> samples = readSamples(file, inputs + system.outputs.size());
    EXPECT_EQ(samples.size(), 60);
    for (const Sample& sample : samples) {
        std::vector<std::optional<double>> values(inputs);
        for (std::size_t i = 0; i < inputs; ++i)
            if (!std::isnan(sample.numbers[i])) values[i] = sample.numbers[i];
        const InferenceResult result = infer(system, values);
        for (std::size_t i = 0; i < system.outputs.size(); ++i) {
            const double expected = sample.numbers[inputs + i];
            EXPECT_EQ(result.outputs[i].has_value(), !std::isnan(expected)) << "line " << sample.line;
            if (!result.outputs[i] || std::isnan(expected)) continue;
            EXPECT_LE(std::abs(*result.outputs[i] - expected), 1e-9 * std::abs(expected))
                << "line " << sample.line;
        }
    }
}

} // namespace

TEST(Inference, ReproducesTheSamplesOfSusilapG) {
    expectSamples("susilap-g");
}
TEST(Inference, ReproducesTheSamplesOfRoboSim) {
    expectSamples("robo-sim");
}

// [R C.1, C.2]; the shipped sets are a calibration that comes this near to them.
TEST(Inference, ReproducesThePublishedPairs) {
    struct Pair {
        const char* system;
        std::vector<std::optional<double>> inputs;
        double springConstant, viscosity;
    };
    for (const Pair& pair : {Pair{"susilap-g", {5.5}, 16.2606, 2.87713},
                             {"susilap-g", {2.5}, 2.41327, 10.6875},
                             {"susilap-g", {7.0}, 11.3536, 9.13015},
                             {"susilap-g", {10.1}, 81.3091, 6},
                             {"robo-sim", {7.3, 4.9, 3.0}, 45.4871, 72.8125}}) {
        const FuzzySystem system = fuzzyPreset(pair.system);
        ASSERT_EQ(system.outputs[0].name, "spring_const");
        ASSERT_EQ(system.outputs[1].name, "viscosity");
        const InferenceResult result = infer(system, pair.inputs);
        EXPECT_NEAR(result.outputs[0].value(), pair.springConstant, 2e-4 * pair.springConstant);
        EXPECT_NEAR(result.outputs[1].value(), pair.viscosity, 2e-4 * pair.viscosity);
    }
}

TEST(Inference, FindsTheCentreAtTheBoundsOfItsRanges) {
    FuzzySystem system = degreeSystem({{-1e30, -1e30, 1e30, 1e30}, {-1e30, -1e30, -1e30, 1e30}}, {0.5, 1});
    system.outputs[0].minimum = -1e30;
    system.outputs[0].maximum = 1e30;
    // ½ everywhere, and a slope from 1 to ½ over the left half.
    const double expected = (0.5 * 2 * 0 + 0.25 * (-1 + 1.0 / 3)) / (0.5 * 2 + 0.25);
    EXPECT_NEAR(infer(system, {0.0, 0.0}).outputs[0].value() / 1e30, expected, 1e-12);
}

TEST(Inference, FindsTheCentreOfOneSetInClosedForm) {
    EXPECT_DOUBLE_EQ(centre({{0, 2, 4, 6}}, {1}).value(), 3);
    EXPECT_DOUBLE_EQ(centre({{0, 2, 4, 6}}, {0.3}).value(), 3);
    EXPECT_DOUBLE_EQ(centre({{0, 0, 0, 3}}, {1}).value(), 1); // a right triangle's third
    EXPECT_DOUBLE_EQ(centre({{-3, 0, 0, 0}}, {1}).value(), -1);
    // Cut at ½: 1·1 box at x ½, area ½, and a triangle 1 wide, area ¼, centre 1 + ⅓.
    EXPECT_DOUBLE_EQ(centre({{0, 0, 0, 2}}, {0.5}).value(), (0.5 * 0.5 + 0.25 * (4.0 / 3)) / 0.75);
    EXPECT_DOUBLE_EQ(centre({{2, 2, 5, 5}}, {0.25}).value(), 3.5);
}

TEST(Inference, FindsTheCentreOfOverlappingSetsInClosedForm) {
    // Boxes 0 to 2 at height 1 and 1 to 4 at height ½: areas 2 and 1 (2 to 4).
    EXPECT_DOUBLE_EQ(centre({{0, 0, 2, 2}, {1, 1, 4, 4}}, {1, 0.5}).value(), (2 * 1 + 1 * 3) / 3.0);
    // Two triangles 0 to 4 and 2 to 6 cross at x = 3, height ½: symmetric about 3.
    EXPECT_DOUBLE_EQ(centre({{0, 2, 2, 4}, {2, 4, 4, 6}}, {1, 1}).value(), 3);
    // A set within another adds nothing.
    EXPECT_DOUBLE_EQ(centre({{0, 2, 4, 6}, {1, 2, 4, 5}}, {0.8, 0.7}).value(), 3);
    // Apart: centres weighted by areas ½·2 and 1·1.
    EXPECT_DOUBLE_EQ(centre({{0, 0, 2, 2}, {10, 10, 11, 11}}, {0.5, 1}).value(), (1 + 10.5) / 2);
}

TEST(Inference, AgreesWithBruteForceForArbitrarySets) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-100, 100), degree(0.01, 1);
    for (int trial = 0; trial < 12; ++trial) {
        std::vector<Trapezoid> sets;
        std::vector<double> degrees;
        for (int i = 0; i < 2 + trial % 5; ++i) {
            std::array<double, 4> corners{place(random), place(random), place(random), place(random)};
            std::sort(corners.begin(), corners.end());
            sets.push_back({corners[0], corners[1], corners[2], corners[3]});
            degrees.push_back(degree(random));
        }
        const auto expected = static_cast<double>(bruteCentre(sets, degrees, -100, 100));
        EXPECT_NEAR(centre(sets, degrees).value(), expected, 2e-7) << trial;
    }
}

TEST(Inference, KeepsToTheRangeOfTheOutput) {
    FuzzySystem system = degreeSystem({{-10, 0, 0, 10}}, {1});
    system.outputs[0].minimum = 0;
    system.outputs[0].maximum = 5;
    // What remains falls from 1 at 0 to ½ at 5.
    EXPECT_DOUBLE_EQ(infer(system, {0.0}).outputs[0].value(), 5 * (1 + 2 * 0.5) / (3 * 1.5));
}

TEST(Inference, TakesTheWeightedMeanOfPoints) {
    EXPECT_DOUBLE_EQ(centre({{4, 4, 4, 4}}, {0.2}).value(), 4);
    EXPECT_DOUBLE_EQ(centre({{4, 4, 4, 4}, {10, 10, 10, 10}}, {0.75, 0.25}).value(), 5.5);
    EXPECT_DOUBLE_EQ(centre({{4, 4, 4, 4}, {9, 9, 11, 11}}, {1, 0.01}).value(),
                     10); // a point has no weight beside area
}

TEST(Inference, StaysInRangeAtTheSmallestDegrees) {
    for (const double degree : {1e-3, 1e-9, 1e-15}) {
        const double y = centre({{0, 2, 4, 6}, {5, 7, 9, 11}}, {degree, degree}).value();
        EXPECT_NEAR(y, 5.5, 1e-6) << degree;
    }
}

TEST(Inference, HasNoOutputWhereNoRuleFires) {
    const FuzzySystem system = fuzzyPreset("robo-sim");
    const InferenceResult none = infer(system, {std::nullopt, std::nullopt, std::nullopt});
    EXPECT_THAT(none.outputs, ElementsAre(std::nullopt, std::nullopt));
    EXPECT_THAT(none.firing, testing::Each(0.0));
    EXPECT_EQ(none.firing.size(), 14);
    const InferenceResult solid = infer(system, {10.0, std::nullopt, std::nullopt});
    EXPECT_TRUE(solid.outputs[0]);
    EXPECT_FALSE(solid.outputs[1]);
    EXPECT_EQ(solid.firing[0], 1);
    EXPECT_FALSE(infer(system, {NAN, std::nullopt, std::nullopt}).outputs[0]);
}

TEST(Inference, TakesTheLeastDegreeOfARulesConditions) {
    FuzzySystem system = degreeSystem({{0, 1, 1, 2}, {4, 5, 5, 6}}, {0.8, 0.3});
    system.rules = {{conjunction({{{0, 0}}, {{1, 0}}}), {{0, 0}, {0, 1}}}};
    const InferenceResult both = infer(system, {0.0, 0.0});
    ASSERT_EQ(both.firing.size(), 1);
    EXPECT_DOUBLE_EQ(both.firing[0], 0.3);
    EXPECT_DOUBLE_EQ(both.outputs[0].value(), 3);
    EXPECT_FALSE(infer(system, {0.0, std::nullopt}).outputs[0]);
}

namespace {

/// To what degree a rule fires whose condition speaks of inputs to these degrees.
double firing(const FuzzyCondition& condition, const std::vector<double>& degrees,
              const FuzzyNorms& norms = {}) {
    FuzzySystem system = degreeSystem(std::vector<Trapezoid>(degrees.size(), {0, 1, 1, 2}), degrees);
    system.norms = norms;
    system.rules = {{condition, {{0, 0}}}};
    return infer(system, std::vector<std::optional<double>>(degrees.size(), 0.0)).firing[0];
}

} // namespace

TEST(Inference, CombinesConditionsByTheNorms) {
    const FuzzyCondition a{{0, 0}}, b{{1, 0}}, c{{2, 0}};
    const FuzzyNorms usual, product{TNorm::Product, TConorm::ProbabilisticSum, {}, {}},
        bounded{TNorm::BoundedDifference, TConorm::BoundedSum, {}, {}};
    const std::vector<double> degrees{0.75, 0.5, 0.625};
    EXPECT_EQ(firing(conjunction({a, b, c}), degrees, usual), 0.5);
    EXPECT_EQ(firing(conjunction({a, b, c}), degrees, product), 0.234375);
    EXPECT_EQ(firing(conjunction({a, b, c}), degrees, bounded), 0);
    EXPECT_EQ(firing(conjunction({a, b}), degrees, bounded), 0.25);
    EXPECT_EQ(firing(disjunction({a, b, c}), degrees, usual), 0.75);
    EXPECT_EQ(firing(disjunction({a, b, c}), degrees, product), 0.953125);
    EXPECT_EQ(firing(disjunction({a, b, c}), degrees, bounded), 1);
    EXPECT_EQ(firing(negation(a), degrees), 0.25);
    EXPECT_EQ(firing(negation(disjunction({negation(a), conjunction({b, c})})), degrees), 0.5);
}

TEST(Inference, MultipliesARulesDegreeByItsWeight) {
    FuzzySystem system = degreeSystem({{0, 0, 2, 2}, {2, 2, 4, 4}}, {0.5, 0.75});
    system.rules[0].weight = 0.5;
    EXPECT_THAT(infer(system, {0.0, 0.0}).firing, ElementsAre(0.25, 0.75));
    EXPECT_DOUBLE_EQ(centreOf(system).value(), (0.25 * 1 + 0.75 * 3) / 1);
    system.rules[1].weight = 0;
    EXPECT_DOUBLE_EQ(centreOf(system).value(), 1);
}

TEST(Inference, DoesNotFireARuleOfWhichAPartIsUnknown) {
    FuzzySystem system = degreeSystem({{0, 1, 1, 2}, {4, 5, 5, 6}}, {0.5, 0.5});
    const FuzzyCondition first{{0, 0}}, second{{1, 0}};
    for (const FuzzyCondition& condition :
         {negation(second), disjunction({first, second}), disjunction({second, first}),
          negation(conjunction({first, second}))}) {
        system.rules = {{condition, {{0, 0}}}};
        EXPECT_THAT(infer(system, {0.0, std::nullopt}).firing, ElementsAre(0));
        EXPECT_THAT(infer(system, {0.0, NAN}).firing, ElementsAre(0));
        EXPECT_FALSE(infer(system, {0.0, std::nullopt}).outputs[0]);
        EXPECT_TRUE(infer(system, {0.0, 0.0}).outputs[0]);
    }
}

TEST(OrderedInputs, PutsNamesInTheSystemsOrder) {
    const FuzzySystem system = fuzzyPreset("robo-sim");
    EXPECT_THAT(orderedInputs(system, {{"shiftability", 3}, {"consistency", 7.3}}),
                ElementsAre(7.3, std::nullopt, 3.0));
}

TEST(OrderedInputs, RefusesUnknownAndNonFiniteOnesTogether) {
    try {
        orderedInputs(fuzzyPreset("robo-sim"), {{"shift", 3}, {"consistency", INFINITY}});
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.problems(),
                    ElementsAre(testing::AllOf(HasSubstr("\"shift\""), HasSubstr("shiftability")),
                                HasSubstr("consistency")));
    }
}

TEST(InWords, NamesTheTermsAValueBelongsTo) {
    const FuzzyVariable consistency = fuzzyPreset("susilap-g").inputs[0];
    EXPECT_EQ(inWords(consistency, 5.5), "flexible 0.92, medium 0.08");
    EXPECT_EQ(inWords(consistency, 1), "very_soft 1.00");
    EXPECT_EQ(inWords(consistency, 13), "none");
}

#include "core/fuzzy/centre_of_gravity.h"

#include "tests/core/fuzzy/degree_system.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace esm;

namespace {

std::optional<double> centreBy(const FuzzyNorms& norms, const std::vector<Trapezoid>& sets,
                               const std::vector<double>& degrees) {
    FuzzySystem system = degreeSystem(sets, degrees);
    system.norms = norms;
    return centreOf(system);
}

FuzzyNorms normsOf(TNorm implication, TConorm aggregation) {
    return {TNorm::Minimum, TConorm::Maximum, implication, aggregation};
}

} // namespace

// Made by exact_centres.py in rational arithmetic.
TEST(CentreOfGravity, IsThatOfRationalArithmetic) {
    std::ifstream table(std::string(ESM_SOURCE_DIR) + "/tests/core/fuzzy/exact_centres.csv");
    std::string line;
    std::getline(table, line);
    int count = 0;
    for (; std::getline(table, line); ++count) {
        std::istringstream row(line);
        std::string implication, aggregation, minimum, maximum, expected;
        for (std::string* cell : {&implication, &aggregation, &minimum, &maximum, &expected})
            std::getline(row, *cell, ',');
        std::vector<Trapezoid> sets;
        std::vector<double> degrees;
        Trapezoid set;
        for (double degree = 0; row >> set.a >> set.b >> set.c >> set.d >> degree;) {
            sets.push_back(set);
            degrees.push_back(degree);
        }
        FuzzySystem system = degreeSystem(sets, degrees);
        system.outputs[0].minimum = std::stod(minimum);
        system.outputs[0].maximum = std::stod(maximum);
        system.norms = normsOf(fromWord<TNorm>(implication).value(), fromWord<TConorm>(aggregation).value());
        const double centre = std::stod(expected);
        EXPECT_NEAR(centreOf(system).value(), centre, 1e-12 * std::max(1.0, std::abs(centre)))
            << sets.size() << " conclusions, " << implication << ", " << aggregation;
    }
    EXPECT_EQ(count, 63);
}

TEST(CentreOfGravity, TakesWhatTheImplicationLeaves) {
    const Trapezoid ramp{0, 4, 4, 4}; // at ½: cut off at 2, half as steep, or from 2 on
    const auto centre = [&](TNorm implication) {
        return centreBy(normsOf(implication, TConorm::Maximum), {ramp}, {0.5}).value();
    };
    EXPECT_DOUBLE_EQ(centre(TNorm::Minimum), (0.5 * 4 / 3 + 1 * 3) / 1.5);
    EXPECT_DOUBLE_EQ(centre(TNorm::Product), 8.0 / 3);
    EXPECT_DOUBLE_EQ(centre(TNorm::BoundedDifference), 2 + 4.0 / 3);
}

TEST(CentreOfGravity, TakesWhatTheAggregationMakesOfOverlap) {
    // Boxes 0 to 2 at ½ and 1 to 3 at ¾.
    const auto centre = [&](TConorm aggregation) {
        return centreBy(normsOf(TNorm::Minimum, aggregation), {{0, 0, 2, 2}, {1, 1, 3, 3}}, {0.5, 0.75})
            .value();
    };
    const auto mean = [](double overlap) {
        return (0.5 * 0.5 + overlap * 1.5 + 0.75 * 2.5) / (0.5 + overlap + 0.75);
    };
    EXPECT_DOUBLE_EQ(centre(TConorm::Maximum), mean(0.75));
    EXPECT_DOUBLE_EQ(centre(TConorm::ProbabilisticSum), mean(0.875));
    EXPECT_DOUBLE_EQ(centre(TConorm::BoundedSum), mean(1));
}

TEST(CentreOfGravity, CountsEveryRuleUnderASumAndTheStrongestUnderTheMaximum) {
    const auto centre = [](TConorm aggregation) {
        FuzzySystem system = degreeSystem({{0, 0, 2, 2}, {2, 2, 4, 4}}, {0.5, 0.5});
        system.norms.aggregation = aggregation;
        system.rules.push_back(system.rules[1]);
        return centreOf(system).value();
    };
    EXPECT_DOUBLE_EQ(centre(TConorm::Maximum), 2);
    EXPECT_DOUBLE_EQ(centre(TConorm::ProbabilisticSum), (1 * 1 + 1.5 * 3) / 2.5);
    EXPECT_DOUBLE_EQ(centre(TConorm::BoundedSum), (1 * 1 + 2 * 3) / 3.0);
}

TEST(CentreOfGravity, OfPointsCombinesThoseAtOnePlace) {
    const std::vector<Trapezoid> points{{4, 4, 4, 4}, {8, 8, 8, 8}, {4, 4, 4, 4}};
    const auto centre = [&](TConorm aggregation) {
        return centreBy(normsOf(TNorm::Minimum, aggregation), points, {0.5, 0.5, 0.25}).value();
    };
    EXPECT_DOUBLE_EQ(centre(TConorm::Maximum), 6);
    EXPECT_DOUBLE_EQ(centre(TConorm::ProbabilisticSum), (0.625 * 4 + 0.5 * 8) / 1.125);
    EXPECT_DOUBLE_EQ(centre(TConorm::BoundedSum), (0.75 * 4 + 0.5 * 8) / 1.25);
}

// A set that only its foot brings into the range leaves it when it sinks.
TEST(CentreOfGravity, IsEmptyWhereNothingIsLeftInTheRange) {
    FuzzySystem system = degreeSystem({{-4, -4, -4, 1}}, {0.5});
    system.outputs[0].minimum = 0;
    EXPECT_TRUE(centreOf(system));
    system.norms.implication = TNorm::BoundedDifference;
    EXPECT_FALSE(centreOf(system));
}

TEST(CentreOfGravity, StaysInTheSetsAtTheSmallestDegrees) {
    for (const TNorm implication : {TNorm::Minimum, TNorm::Product, TNorm::BoundedDifference})
        for (const TConorm aggregation : {TConorm::Maximum, TConorm::ProbabilisticSum, TConorm::BoundedSum})
            for (const double degree : {1e-9, 1e-15, 1e-300, 5e-324}) {
                FuzzySystem system = degreeSystem({{0, 2, 4, 6}, {5, 7, 9, 11}}, {1, 1});
                for (FuzzyRule& rule : system.rules)
                    rule.weight = degree;
                system.norms = normsOf(implication, aggregation);
                const double y = centreOf(system).value_or(NAN);
                EXPECT_NEAR(y, 5.5, degree > 1e-10 ? 1e-6 : 2.5) << degree;
            }
}

// n ramps x over 0 to 1 make 1 − (1 − x)ⁿ together.
TEST(CentreOfGravity, IsExactForPolynomialsOfAnyDegree) {
    FuzzySystem system = degreeSystem({{0, 1, 1, 1}}, {1});
    system.norms = normsOf(TNorm::Product, TConorm::ProbabilisticSum);
    for (const std::size_t n : {1U, 2U, 3U, 6U, 7U, 14U, 15U, 29U, 30U, 31U, 100U, 2000U}) {
        system.rules.assign(n, system.rules[0]);
        const auto count = static_cast<double>(n);
        const double area = 1 - 1 / (count + 1), moment = 0.5 - 1 / ((count + 1) * (count + 2));
        EXPECT_NEAR(centreOf(system).value(), moment / area, 1e-14) << n;
    }
}

#include "core/fuzzy/fuzzy_system.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

FuzzySystem sound() {
    FuzzySystem system;
    system.inputs = {{"age", 0, 9, {{"young", {0, 0, 2, 4}}, {"old", {4, 9, 9, 9}}}},
                     {"zeal", 0, 1, {{"much", {0.5, 1, 1, 1}}}}};
    system.outputs = {{"viscosity", 0, 5, {{"thin", {0, 0, 1, 2}}, {"thick", {3, 4, 5, 5}}}}};
    system.rules = {{conjunction({{{0, 1}}, {{1, 0}}}), {{0, 1}}}};
    return system;
}

} // namespace

TEST(Trapezoid, RisesStaysAndFalls) {
    const Trapezoid set{1, 3, 4, 8};
    const std::vector<std::pair<double, double>> expected{{0, 0},   {1, 0},   {1.5, 0.25},   {3, 1},
                                                          {3.5, 1}, {4, 1},   {5, 0.75},     {8, 0},
                                                          {9, 0},   {NAN, 0}, {INFINITY, 0}, {-INFINITY, 0}};
    for (const auto& [x, degree] : expected)
        EXPECT_DOUBLE_EQ(membership(set, x), degree) << x;
}

TEST(Trapezoid, HasShouldersThatEndWithTheDomain) {
    EXPECT_EQ(membership({0, 0, 1, 2}, 0), 1);
    EXPECT_EQ(membership({0, 0, 1, 2}, -1e-9), 0);
    EXPECT_EQ(membership({8, 9, 10, 10}, 10), 1);
    EXPECT_EQ(membership({8, 9, 10, 10}, 10.001), 0);
    EXPECT_EQ(membership({5, 5, 5, 5}, 5), 1);
    EXPECT_EQ(membership({5, 5, 5, 5}, 5.001), 0);
}

TEST(FuzzySystem, ThatIsSoundHasNoProblem) {
    EXPECT_THAT(validate(sound()), IsEmpty());
}

TEST(FuzzySystem, ReportsEveryProblemWithItsPlace) {
    FuzzySystem system = sound();
    system.inputs[0].name = "";
    system.inputs[1].terms = {};
    system.inputs[1].maximum = 0;
    system.outputs[0].name = "zeal";
    system.outputs[0].terms[0].set = {0, 2, 1, 2};
    system.outputs[0].terms[1] = {"thin", {6, 7, 8, NAN}};
    system.rules = {{{{0, 2}}, {{1, 0}}, 2}, {conjunction({{{0, 0}}}), {}, NAN}};
    EXPECT_THAT(
        validate(system),
        ElementsAre("inputs.: the name is missing",
                    "inputs.zeal.range: must be two finite numbers up to 1e+30, the smaller first, got 0, 0",
                    "inputs.zeal.terms: there must be at least one",
                    "outputs.zeal.terms.thin: the corners must rise, got 0, 2, 1, 2",
                    "outputs.zeal.terms.thin: the corners must be finite numbers up to 1e+30",
                    "outputs.zeal.terms.thin: the name is there twice",
                    "outputs.zeal: the name is there twice",
                    "outputs.zeal.terms.thin: lies outside the output's range",
                    "rules[0], condition: speaks of a variable or term that is not there",
                    "rules[0], conclusions: speaks of a variable or term that is not there",
                    "rules[0], weight: must be a number from 0 to 1, got 2",
                    "rules[1], condition: AND and OR join two conditions or more, NOT takes one",
                    "rules[1], conclusions: there must be at least one",
                    "rules[1], weight: must be a number from 0 to 1, got nan"));
    EXPECT_THAT(validate(FuzzySystem{}),
                ElementsAre("inputs: there must be at least one", "outputs: there must be at least one"));
}

TEST(FuzzySystem, TellsThePartThatAProblemIsOf) {
    FuzzySystem system = sound();
    system.inputs[1].maximum = system.inputs[1].minimum;
    system.outputs[0].terms[1].name = "";
    system.rules[0].weight = 2;
    const std::vector<FuzzyProblem> problems = problemsOf(system);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].part->list, FuzzyPart::List::Inputs);
    EXPECT_EQ(problems[0].part->variable, 1U);
    EXPECT_FALSE(problems[0].part->term);
    EXPECT_EQ(problems[1].part->list, FuzzyPart::List::Outputs);
    EXPECT_EQ(problems[1].part->term, 1U);
    EXPECT_FALSE(problems[2].part);
}

TEST(FuzzySystem, RefusesNamesAndUnitsWithoutEnd) {
    FuzzySystem system = sound();
    system.inputs[0].name = std::string(501, 'x');
    system.inputs[1].unit = std::string(501, 'x');
    EXPECT_THAT(validate(system), ElementsAre(HasSubstr(": a name may have 500 bytes, this one has 501"),
                                              HasSubstr(".unit: may have 500 bytes")));
}

TEST(FuzzySystem, RefusesOutputSetsThatOnlyTouchTheRange) {
    const auto problemsOf = [](const Trapezoid& set) {
        FuzzySystem system = sound();
        system.outputs[0].terms[1].set = set; // the range is 0 to 5
        return validate(system);
    };
    for (const Trapezoid& set :
         {Trapezoid{-9, -5, -5, 0}, {-9, -5, 0, 0}, {5, 5, 6, 7}, {5, 6, 6, 7}, {6, 6, 6, 6}})
        EXPECT_THAT(problemsOf(set), ElementsAre(HasSubstr("thick: lies outside the output's range")))
            << set.a;
    for (const Trapezoid& set :
         {Trapezoid{-9, -5, -5, 0.1}, {4.9, 5, 6, 7}, {0, 0, 0, 0}, {5, 5, 5, 5}, {-9, -9, 9, 9}})
        EXPECT_THAT(problemsOf(set), IsEmpty()) << set.a;
}

TEST(FuzzySystem, BoundsRangesAndCorners) {
    FuzzySystem system = sound();
    system.outputs[0] = {
        "viscosity", -1e30, 1e30, {{"thin", {-1e30, -1e30, 0, 1e30}}, {"thick", {0, 1, 1, 1}}}};
    EXPECT_THAT(validate(system), IsEmpty());
    system.outputs[0].maximum = 1.1e30;
    system.outputs[0].terms[0].set.d = 2e30;
    EXPECT_THAT(validate(system), testing::SizeIs(2));
}

TEST(FuzzySystem, RefusesNamesARuleCouldNotSpeak) {
    for (const char* name : {"very old", "tab\tbed", "is", "Then", "AND", "if", "line\nbreak", "not", "Or",
                             "WITH", "stiff(er)", ")"}) {
        FuzzySystem system = sound();
        system.inputs[0].terms[0].name = name;
        EXPECT_EQ(validate(system).size(), 1) << name;
    }
}

TEST(FuzzySystem, RefusesConditionsOfAShapeThatMeansNothing) {
    const FuzzyCondition leaf{{0, 1}};
    FuzzyCondition leafWithParts = leaf, twoNegated = negation(leaf);
    leafWithParts.parts = {leaf};
    twoNegated.parts.push_back(leaf);
    for (const FuzzyCondition& condition :
         {leafWithParts, twoNegated, conjunction({leaf}), disjunction({}), negation(conjunction({leaf}))}) {
        FuzzySystem system = sound();
        system.rules[0].condition = condition;
        EXPECT_THAT(validate(system), ElementsAre(HasSubstr("rules[0], condition: AND and OR join two")));
    }
    FuzzySystem system = sound();
    system.rules[0].condition = disjunction({leaf, negation(conjunction({leaf, {{0, 2}}}))});
    EXPECT_THAT(validate(system), ElementsAre(HasSubstr("condition: speaks of a variable or term")));
}

TEST(FuzzySystem, BoundsHowDeepConditionsAreAndHowManyRules) {
    FuzzySystem system = sound();
    FuzzyCondition& condition = system.rules[0].condition;
    for (condition = {{0, 1}}; !isDeeperThan(deepestCondition - 1, condition);)
        condition = negation(condition);
    EXPECT_THAT(validate(system), IsEmpty());
    condition = negation(condition);
    EXPECT_THAT(validate(system), ElementsAre("rules[0], condition: is nested deeper than 100"));

    system = sound();
    system.rules.assign(mostFuzzyRules, system.rules[0]);
    EXPECT_THAT(validate(system), IsEmpty());
    for (FuzzyRule& rule : system.rules)
        rule.conclusions.assign(3, rule.conclusions[0]);
    EXPECT_THAT(validate(system),
                ElementsAre("rules: there are 6000 conclusions in all; a system may have 4000"));
    system.rules.assign(10000, system.rules[0]);
    EXPECT_THAT(validate(system), ElementsAre("rules: there are 10000; a system may have 2000"));
}

TEST(FuzzySystem, BoundsHowManyInputsAndTermsThereAre) {
    FuzzySystem system = sound();
    std::vector<FuzzyTerm>& terms = system.inputs[0].terms;
    while (terms.size() < mostFuzzyWords)
        terms.push_back({"term" + std::to_string(terms.size()), terms[0].set});
    EXPECT_THAT(validate(system), IsEmpty());
    terms.push_back({"last", terms[0].set});
    EXPECT_THAT(validate(system),
                ElementsAre(testing::HasSubstr(".terms: there are 2001; there may be 2000")));
    system = sound();
    while (system.inputs.size() <= mostFuzzyWords) {
        system.inputs.push_back(system.inputs[0]);
        system.inputs.back().name = "input" + std::to_string(system.inputs.size());
    }
    EXPECT_THAT(validate(system), ElementsAre("inputs: there are 2001; there may be 2000"));
}

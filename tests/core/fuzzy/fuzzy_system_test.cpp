#include "core/fuzzy/fuzzy_system.h"

#include "core/support/errors.h"

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
    system.rules = {{{{0, 1}, {1, 0}}, {{0, 1}}}};
    return system;
}

std::string complaint(const std::string& rule) {
    try {
        parseRule(sound(), rule);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "accepted";
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
    system.rules = {{{{0, 2}}, {{1, 0}}}, {}};
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
                    "rules[0], conditions: speaks of a variable or term that is not there",
                    "rules[0], conclusions: speaks of a variable or term that is not there",
                    "rules[1], conditions: there must be at least one",
                    "rules[1], conclusions: there must be at least one"));
    EXPECT_THAT(validate(FuzzySystem{}),
                ElementsAre("inputs: there must be at least one", "outputs: there must be at least one"));
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
    for (const char* name : {"very old", "tab\tbed", "is", "Then", "AND", "if", "line\nbreak"}) {
        FuzzySystem system = sound();
        system.inputs[0].terms[0].name = name;
        EXPECT_EQ(validate(system).size(), 1) << name;
    }
}

TEST(Rule, IsWrittenAsItIsRead) {
    const FuzzySystem system = sound();
    const std::string text = "IF age IS old AND zeal IS much THEN viscosity IS thick";
    EXPECT_EQ(ruleText(system, system.rules[0]), text);
    EXPECT_EQ(ruleText(system, parseRule(system, text)), text);
    EXPECT_EQ(
        ruleText(system, parseRule(system, "  if age\tis old And zeal iS much\nthen viscosity Is thick ")),
        text);
    const std::string two = "IF zeal IS much THEN viscosity IS thin AND viscosity IS thick";
    EXPECT_EQ(ruleText(system, parseRule(system, two)), two);
}

TEST(Rule, ThatCannotBeReadSaysWhereAndWhatWasExpected) {
    EXPECT_EQ(complaint(""), "column 1: expected IF, but the rule ends");
    EXPECT_EQ(complaint("age IS old"), "column 1: expected IF, but found \"age\"");
    EXPECT_EQ(complaint("IF ages IS old THEN viscosity IS thin"),
              "column 4: expected the name of an input (age, zeal), but found \"ages\"");
    EXPECT_EQ(complaint("IF age IS ancient THEN viscosity IS thin"),
              "column 11: expected the name of a term of age (young, old), but found \"ancient\"");
    EXPECT_EQ(complaint("IF age old THEN viscosity IS thin"), "column 8: expected IS, but found \"old\"");
    EXPECT_EQ(complaint("IF age IS old OR zeal IS much THEN viscosity IS thin"),
              "column 15: expected AND or THEN, but found \"OR\"");
    EXPECT_EQ(complaint("IF age IS old"), "column 14: expected AND or THEN, but the rule ends");
    EXPECT_EQ(complaint("IF age IS old THEN age IS old"),
              "column 20: expected the name of an output (viscosity), but found \"age\"");
    EXPECT_EQ(complaint("IF age IS old THEN viscosity IS thin ELSE"),
              "column 38: expected AND or the end of the rule, but found \"ELSE\"");
    EXPECT_EQ(complaint("IF Größe IS old"),
              "column 4: expected the name of an input (age, zeal), but found \"Größe\"");
    EXPECT_EQ(complaint("IF  \xC3\xB6\xC3\xB6 x"),
              "column 5: expected the name of an input (age, zeal), but found \"\xC3\xB6\xC3\xB6\"");
    EXPECT_EQ(complaint("IF age \xC3\xB6 old"), "column 8: expected IS, but found \"\xC3\xB6\"");
    EXPECT_EQ(complaint("IF age IS \xC3\xB6\xC3\xB6 THEN"),
              "column 11: expected the name of a term of age (young, old), but found \"\xC3\xB6\xC3\xB6\"");
}

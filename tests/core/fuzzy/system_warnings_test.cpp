#include "core/fuzzy/system_warnings.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/empty_outputs.h"
#include "core/fuzzy/inference.h"
#include "core/support/joined.h"
#include "tests/core/fuzzy/age_and_zeal.h"

#include <gmock/gmock.h>

#include <random>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

using WarningKind = SystemWarning::Kind;

std::vector<std::string> warningsOf(const FuzzySystem& system, WarningKind kind) {
    std::vector<std::string> texts;
    for (const SystemWarning& warning : systemWarnings(system))
        if (warning.kind == kind) texts.push_back(warning.text);
    return texts;
}

std::vector<std::string> warnings(const std::vector<std::string>& rules, WarningKind kind) {
    return warningsOf(ageAndZealSystem(rules), kind);
}

std::vector<std::string> contradictions(const std::string& one, const std::string& other) {
    return warnings({"IF " + one + " THEN viscosity IS thin", "IF " + other + " THEN viscosity IS thick"},
                    WarningKind::Contradiction);
}

std::vector<ValueRange> uncoveredRanges(const FuzzySystem& system, std::size_t input) {
    RuleReach reach(system);
    return uncoveredRanges(factsOfRules(system, reach), input, reach.cells(input));
}

bool holdValue(const std::vector<ValueRange>& ranges, double value) {
    return std::any_of(ranges.begin(), ranges.end(), [&](const ValueRange& range) {
        return (value > range.from || (value == range.from && range.includesFrom)) &&
               (value < range.to || (value == range.to && range.includesTo));
    });
}

/// Systems with corners at whole numbers, so that halves come upon whatever lies between them.
class UnevenSystems {
public:
    static constexpr int most = 6; ///< range of the inputs

    FuzzySystem next() {
        FuzzySystem system;
        for (int input = 0; input < 3; ++input) {
            FuzzyVariable variable{"x" + std::to_string(input), 0, most, {}};
            for (int term = 0; term < 3; ++term)
                variable.terms.push_back({"t" + std::to_string(term), set()});
            system.inputs.push_back(variable);
        }
        system.outputs = {{"y", 0, 1, {{"low", {0, 0, 1, 1}}}}};
        for (int rule = number(1, 4); rule > 0; --rule)
            system.rules.push_back({condition(3), {{0, 0}}, number(0, 4) > 0 ? 0.5 : 0.0});
        if (number(0, 1)) system.norms.conjunction = TNorm::Product;
        if (number(0, 1)) system.norms.disjunction = TConorm::ProbabilisticSum;
        return system;
    }

private:
    int number(int least, int greatest) {
        return std::uniform_int_distribution<int>(least, greatest)(m_random);
    }
    Trapezoid set() {
        std::array<int, 4> corners{};
        for (int& corner : corners)
            corner = number(-1, most + 1);
        std::sort(corners.begin(), corners.end());
        return {double(corners[0]), double(corners[1]), double(corners[2]), double(corners[3])};
    }
    FuzzyCondition condition(int levels) {
        const int kind = levels > 0 ? number(0, 5) : 0;
        if (kind == 1) return negation(condition(levels - 1));
        if (kind == 2 || kind == 3) return conjunction({condition(levels - 1), condition(levels - 1)});
        if (kind == 4) return disjunction({condition(levels - 1), condition(levels - 1)});
        return {{std::size_t(number(0, 2)), std::size_t(number(0, 2))}};
    }

    std::mt19937 m_random{7};
};

bool asksFor(const FuzzyCondition& condition, std::size_t input) {
    if (condition.kind == FuzzyCondition::Kind::Is) return condition.proposition.variable == input;
    return std::any_of(condition.parts.begin(), condition.parts.end(),
                       [&](const FuzzyCondition& part) { return asksFor(part, input); });
}

/// By inference at every whole and half number: per input, the values at which a rule that asks for it fires.
std::vector<std::vector<bool>> firingBySampling(const FuzzySystem& system) {
    constexpr std::size_t samples = 2 * UnevenSystems::most + 1;
    std::vector<std::vector<bool>> fires(3, std::vector<bool>(samples, false));
    std::array<std::size_t, 3> at{};
    for (at[0] = 0; at[0] < samples; ++at[0])
        for (at[1] = 0; at[1] < samples; ++at[1])
            for (at[2] = 0; at[2] < samples; ++at[2]) {
                const auto result = infer(system, {double(at[0]) / 2, double(at[1]) / 2, double(at[2]) / 2});
                for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
                    for (std::size_t input = 0; input < 3; ++input)
                        if (result.firing[rule] > 0 && asksFor(system.rules[rule].condition, input))
                            fires[input][at[input]] = true;
            }
    return fires;
}

bool holdsValue(const RuleReach& reach, std::size_t input, const CellSet& cells, double value) {
    return holdValue(rangesOf(reach.cells(input), cells), value);
}

/// How many of the cases hold these values.
int casesOf(const EmptyCases& cases, const RuleReach& reach, const std::vector<double>& values) {
    int count = 0;
    for (std::size_t input = 0; input < values.size(); ++input)
        count += holdsValue(reach, input, cases.decided[input], values[input]);
    if (count > 0) return 1;
    for (const ValueBox& box : cases.combined)
        count += std::all_of(box.begin(), box.end(), [&](const auto& entry) {
            return holdsValue(reach, entry.first, entry.second, values[entry.first]);
        });
    return count;
}

std::vector<std::string> emptyOutputs(const std::vector<std::string>& rules) {
    return warnings(rules, WarningKind::EmptyOutput);
}

constexpr const char* notAllChecked =
    "There are too many rules, or too intricate ones, to check all of them.";

/// Inputs x0 to x17 (s, t), an input z of terms that do not meet, and an output y (low, high).
FuzzySystem intricateSystem() {
    FuzzySystem system;
    for (int i = 0; i < 18; ++i)
        system.inputs.push_back({"x" + std::to_string(i), 0, 9, {{"s", {0, 0, 4, 5}}, {"t", {4, 5, 9, 9}}}});
    system.inputs.push_back({"z", 0, 300, {}});
    for (int i = 0; i < 300; ++i)
        system.inputs.back().terms.push_back({"t" + std::to_string(i), {i + 0.1, i + 0.2, i + 0.3, i + 0.4}});
    system.outputs = {{"y", 0, 1, {{"low", {0, 0, 1, 1}}, {"high", {0, 0, 1, 1}}}}};
    return system;
}

/// "(x0 IS s OR x1 IS t) AND …", which holds in 2ⁿ boxes for n pairs.
std::string bracketPairs(int pairs) {
    std::vector<std::string> parts;
    for (int i = 0; i < pairs; ++i)
        parts.push_back("(x" + std::to_string(2 * i) + " IS s OR x" + std::to_string(2 * i + 1) + " IS t)");
    return joined(parts, " AND ");
}

} // namespace

TEST(UncoveredRanges, AreWhereSamplingFindsNoRule) {
    UnevenSystems systems;
    int uncovered = 0;
    for (int i = 0; i < 60; ++i) {
        const FuzzySystem system = systems.next();
        const auto fires = firingBySampling(system);
        for (std::size_t input = 0; input < 3; ++input) {
            const auto ranges = uncoveredRanges(system, input);
            for (std::size_t sample = 0; sample < fires[input].size(); ++sample) {
                ASSERT_EQ(holdValue(ranges, double(sample) / 2), !fires[input][sample])
                    << "system " << i << ", x" << input << " = " << double(sample) / 2 << "\n"
                    << ruleText(system, system.rules[0]);
                uncovered += !fires[input][sample];
            }
        }
    }
    EXPECT_GT(uncovered, 300) << "there is something to find";
}

TEST(UncoveredRanges, AreExact) {
    FuzzySystem system = ageAndZealSystem({"IF age IS young AND zeal IS much THEN viscosity IS thin",
                                           "IF age IS old AND age IS NOT old THEN viscosity IS thick",
                                           "IF age IS old THEN viscosity IS thick WITH 0"});
    const auto ranges = uncoveredRanges(system, 0);
    ASSERT_THAT(ranges, SizeIs(1));
    EXPECT_EQ(inWords(ranges[0]), "from 4 to 9");
    EXPECT_THAT(warningsOf(system, WarningKind::UncoveredRange),
                ElementsAre("No rule fires where age is from 4 to 9.",
                            "No rule that asks for zeal fires where it is from 0 to 0.2."));
    system.rules.push_back(parseRule(system, "IF zeal IS little THEN mass IS small"));
    EXPECT_THAT(warningsOf(system, WarningKind::UncoveredRange), IsEmpty());
    EXPECT_THAT(warningsOf(system, WarningKind::EmptyOutput),
                ElementsAre("No rule fires for viscosity where age is from 4 to 9.",
                            "No rule fires for viscosity where age is from 0 to 2 and zeal is from 0 to 0.2.",
                            "No rule fires for mass where zeal is from 0.8 to 1."))
        << "the range is told once, with what it leaves empty";
    system.rules.push_back(parseRule(system, "IF zeal IS much THEN viscosity IS thick AND mass IS small"));
    EXPECT_THAT(warningsOf(system, WarningKind::UncoveredRange),
                ElementsAre("No rule that asks for age fires where it is from 4 to 9."));
}

TEST(EmptyCases, AreWhereSamplingFindsNoValue) {
    UnevenSystems systems;
    int empty = 0, combined = 0;
    for (int i = 0; i < 60; ++i) {
        const FuzzySystem system = systems.next();
        RuleReach reach(system);
        std::size_t work = 0;
        const auto cases = emptyCases(factsOfRules(system, reach), 0, reach, work);
        ASSERT_TRUE(cases);
        combined += !cases->combined.empty() && !cases->combined[0].empty();
        for (double x = 0; x <= UnevenSystems::most; x += 0.5)
            for (double y = 0; y <= UnevenSystems::most; y += 0.5)
                for (double z = 0; z <= UnevenSystems::most; z += 0.5) {
                    const bool isEmpty = !infer(system, {x, y, z}).outputs[0];
                    ASSERT_EQ(casesOf(*cases, reach, {x, y, z}), int(isEmpty))
                        << "system " << i << " at " << x << ", " << y << ", " << z << "\n"
                        << ruleText(system, system.rules[0]);
                    empty += isEmpty;
                }
    }
    EXPECT_GT(empty, 1000) << "there is something to find";
    EXPECT_GT(combined, 10) << "some of it takes several inputs";
}

TEST(SystemWarnings, TellWhichValuesOfOneInputLeaveAnOutputEmpty) {
    FuzzySystem system = ageAndZealSystem(
        {"IF age IS young THEN viscosity IS thin AND mass IS small", "IF age IS old THEN mass IS small"});
    system.inputs[0].unit = "a";
    EXPECT_THAT(warningsOf(system, WarningKind::EmptyOutput),
                ElementsAre("No rule fires for viscosity where age is from 4 to 9 a."));
    EXPECT_THAT(warningsOf(system, WarningKind::UncoveredRange), IsEmpty());
    EXPECT_THAT(emptyOutputs({"IF age IS young THEN viscosity IS thin AND mass IS small",
                              "IF age IS young THEN mass IS small"}),
                IsEmpty())
        << "that no rule fires at all is told once";
}

TEST(SystemWarnings, TellWhichValuesOfSeveralInputsLeaveOutputsEmpty) {
    EXPECT_THAT(emptyOutputs({"IF age IS young OR zeal IS much THEN viscosity IS thin AND mass IS small"}),
                ElementsAre("No rule fires for viscosity and mass where age is from 4 to 9 and zeal is from "
                            "0 to 0.2."));
    EXPECT_THAT(
        emptyOutputs({"IF age IS young AND zeal IS much THEN viscosity IS thin",
                      "IF age IS old AND zeal IS little THEN viscosity IS thick"}),
        ElementsAre("No rule fires for viscosity where age is from 4 to 9 and zeal is from 0.8 to 1.",
                    "No rule fires for viscosity where age is from 0 to 2 and zeal is from 0 to 0.2."));
    EXPECT_THAT(emptyOutputs({"IF age IS old THEN viscosity IS thin WITH 0"}),
                ElementsAre("No rule fires for viscosity, whatever the inputs are."));
    EXPECT_THAT(emptyOutputs({"IF age IS young OR age IS old THEN viscosity IS thin"}), IsEmpty());
}

TEST(SystemWarnings, TellTheWidestOfManyCombinationsThatLeaveAnOutputEmpty) {
    FuzzySystem system = ageAndZealSystem();
    system.inputs[0].terms.clear();
    system.inputs[1].terms.clear();
    for (int i = 0; i < 9; ++i) { // each of its own width, so that no two cases are told together
        const double from = i, to = i + 1, most = 0.1 * (i + 1);
        system.inputs[0].terms.push_back({"a" + std::to_string(i), {from, from, to, to}});
        system.inputs[1].terms.push_back({"z" + std::to_string(i), {0, 0, most, most}});
        const std::string number = std::to_string(i);
        system.rules.push_back(
            parseRule(system, "IF age IS a" + number + " AND zeal IS z" + number + " THEN mass IS small"));
    }
    const auto told = warningsOf(system, WarningKind::EmptyOutput);
    ASSERT_THAT(told, SizeIs(mostEmptyCombinations + 1));
    EXPECT_EQ(told[0],
              "No rule fires for mass where age is from 0 to below 1 and zeal is above 0.1, up to 0.9.");
    EXPECT_EQ(told.back(), "No rule fires for mass in 3 more combinations of inputs.");
}

TEST(SystemWarnings, TellContradictionsOnTheSameCondition) {
    EXPECT_THAT(contradictions("age IS old AND zeal IS much", "zeal IS much AND (age IS old)"),
                ElementsAre("Rules 1 and 2 contradict each other on the same condition: viscosity is thin by "
                            "rule 1 and thick by rule 2."));
    EXPECT_THAT(contradictions("NOT (age IS old OR zeal IS much)", "age IS NOT old AND zeal IS NOT much"),
                SizeIs(1));
}

TEST(SystemWarnings, TellContradictionsOfRulesThatHoldFullyAtOnce) {
    EXPECT_THAT(contradictions("age IS NOT young", "age IS old"),
                ElementsAre(HasSubstr("where age is from 4 to 9: viscosity is thin by rule 1")));
    EXPECT_THAT(contradictions("age IS old AND zeal IS much", "age IS old"),
                ElementsAre(HasSubstr("where age is from 4 to 9 and zeal is from 0.8 to 1:")))
        << "the rule for the special case says otherwise than the general one";
    EXPECT_THAT(contradictions("age IS old OR zeal IS much", "age IS young AND zeal IS much"),
                ElementsAre(HasSubstr("where age is from 0 to 2 and zeal is from 0.8 to 1")));
    EXPECT_THAT(contradictions("age IS old", "age IS young"), IsEmpty()) << "they only overlap";
    EXPECT_THAT(contradictions("age IS old", "zeal IS much"), IsEmpty()) << "each is evidence of its own";
    EXPECT_THAT(warnings({"IF age IS old THEN viscosity IS thin", "IF age IS old THEN mass IS small"},
                         WarningKind::Contradiction),
                IsEmpty());
    EXPECT_THAT(
        warnings({"IF age IS old THEN viscosity IS thin", "IF age IS old THEN viscosity IS thick WITH 0"},
                 WarningKind::Contradiction),
        IsEmpty());
    EXPECT_THAT(
        warnings({"IF age IS old THEN viscosity IS thin AND viscosity IS thick"}, WarningKind::Contradiction),
        ElementsAre("Rule 1 contradicts itself: it says that viscosity is thin and thick at once."));
}

TEST(SystemWarnings, TellRulesThatSayTheSame) {
    EXPECT_THAT(warnings({"IF age IS old AND zeal IS much THEN viscosity IS thin AND mass IS small",
                          "IF age IS young THEN viscosity IS thin",
                          "IF zeal IS much AND age IS old THEN mass IS small AND viscosity IS thin"},
                         WarningKind::Duplicate),
                ElementsAre("Rules 1 and 3 say the same."));
    EXPECT_THAT(warnings({"IF age IS old THEN mass IS small", "IF age IS old THEN mass IS small WITH 0.5"},
                         WarningKind::Duplicate),
                ElementsAre("Rules 1 and 2 say the same with different weights."));
    EXPECT_THAT(
        warnings(std::vector<std::string>(46, "IF age IS old THEN mass IS small"), WarningKind::Duplicate),
        ElementsAre("Rules 1, 2, 3, 4, 5, 6 and 40 more say the same."));
}

TEST(SystemWarnings, TellRulesThatNeverFire) {
    FuzzySystem system = ageAndZealSystem({"IF age IS old AND age IS NOT old THEN mass IS small"});
    EXPECT_THAT(warningsOf(system, WarningKind::NeverFires), IsEmpty()) << "the word fits by halves";
    system.inputs[0].terms = {{"young", {0, 0, 2, 4}}, {"old", {4, 6, 9, 9}}};
    system.rules = {parseRule(system, "IF age IS old AND age IS young THEN mass IS small"),
                    parseRule(system, "IF age IS old THEN mass IS small WITH 0")};
    EXPECT_THAT(warningsOf(system, WarningKind::NeverFires),
                ElementsAre("Rule 1 never fires: its condition cannot hold.",
                            "Rule 2 never fires: its weight is 0."));
    EXPECT_THAT(warningsOf(ageAndZealSystem(), WarningKind::NoRule), SizeIs(1));
}

TEST(SystemWarnings, TellWhatIsNotUsed) {
    const FuzzySystem system = ageAndZealSystem({"IF age IS NOT old THEN viscosity IS thin"});
    EXPECT_THAT(warningsOf(system, WarningKind::UnusedTerm),
                ElementsAre("No rule asks whether age is young.", "No rule says that viscosity is thick."));
    EXPECT_THAT(warningsOf(system, WarningKind::UnusedVariable),
                ElementsAre("No rule asks for zeal.", "No rule concludes mass."));
}

TEST(SystemWarnings, TellAGapAndWhatItDoesToTheRulesInOneSentence) {
    FuzzySystem system =
        ageAndZealSystem({"IF age IS old THEN viscosity IS thin", "IF age IS young THEN viscosity IS thick"});
    system.inputs[0].terms[1].set = {5, 6, 9, 9};
    EXPECT_THAT(warningsOf(system, WarningKind::PartitionGap),
                ElementsAre("Where age is from 4 to 5 it belongs to no term, and no rule fires."));
    EXPECT_THAT(warningsOf(system, WarningKind::UncoveredRange), IsEmpty());
    system.rules.push_back(parseRule(system, "IF age IS NOT young THEN viscosity IS thick"));
    EXPECT_THAT(warningsOf(system, WarningKind::PartitionGap),
                ElementsAre("Where age is from 4 to 5 it belongs to no term."));
}

TEST(SystemWarnings, FindInThePresetsOnlyThatAWordIsNotUsed) {
    for (const std::string& name : fuzzyPresetNames())
        for (const SystemWarning& warning : systemWarnings(fuzzyPreset(name)))
            EXPECT_EQ(warning.kind, WarningKind::UnusedTerm) << name << ": " << warning.text;
    EXPECT_THAT(warningsOf(fuzzyPreset("susilap-g"), WarningKind::UnusedTerm),
                ElementsAre("No rule says that spring_const is large."));
}

TEST(SystemWarnings, SayThatThereAreMoreThanAreListed) {
    FuzzySystem system = ageAndZealSystem();
    for (int i = 0; i < 11; ++i)
        system.rules.push_back(parseRule(system, "IF age IS old THEN viscosity IS thin AND mass IS small"));
    system.rules.push_back(parseRule(system, "IF age IS old THEN viscosity IS thick"));
    EXPECT_THAT(warningsOf(system, WarningKind::Contradiction), SizeIs(11));
    EXPECT_THAT(warningsOf(system, WarningKind::NotChecked), IsEmpty());
    for (int i = 0; i < 40; ++i)
        system.rules.push_back(parseRule(system, "IF age IS old THEN viscosity IS thick"));
    EXPECT_THAT(warningsOf(system, WarningKind::Contradiction), SizeIs(mostContradictions));
    EXPECT_THAT(warningsOf(system, WarningKind::NotChecked),
                ElementsAre("There are more contradictions than the 50 that are listed."));
}

TEST(SystemWarnings, SayThatARuleIsTooIntricateToBeCompared) {
    FuzzySystem system = intricateSystem();
    const std::string brackets = bracketPairs(9); // 512 boxes
    system.rules = {parseRule(system, "IF " + brackets + " AND z IS t0 THEN y IS low"),
                    parseRule(system, "IF " + brackets + " THEN y IS high")};
    EXPECT_THAT(warningsOf(system, WarningKind::Contradiction), IsEmpty());
    EXPECT_THAT(warningsOf(system, WarningKind::NotChecked), ElementsAre(notAllChecked));
    system.rules.pop_back();
    EXPECT_THAT(warningsOf(system, WarningKind::NotChecked), ElementsAre(notAllChecked))
        << "where it fires is not known either";
}

TEST(SystemWarnings, TakeNotLongForManyIntricateRules) {
    FuzzySystem system = intricateSystem();
    for (int i = 0; i < 300; ++i)
        system.rules.push_back(parseRule(system, "IF " + bracketPairs(6) + " AND z IS t" + std::to_string(i) +
                                                     " THEN y IS " + (i % 2 ? "low" : "high")));
    EXPECT_THAT(warningsOf(system, WarningKind::Contradiction), IsEmpty()) << "z tells the rules apart";
    EXPECT_THAT(warningsOf(system, WarningKind::NotChecked), ElementsAre(notAllChecked));
}

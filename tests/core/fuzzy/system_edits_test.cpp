#include "core/fuzzy/system_edits.h"

#include "core/fuzzy/inference.h"
#include "core/fuzzy/rule_text.h"
#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

namespace {

constexpr VariablePlace age{FuzzySide::Inputs, 0}, viscosity{FuzzySide::Outputs, 0};

FuzzySystem threeRules() {
    FuzzySystem system;
    system.name = "trial";
    system.inputs = {{"age", 0, 9, {{"young", {0, 0, 2, 4}}, {"grown", {2, 4, 5, 6}}, {"old", {5, 9, 9, 9}}}},
                     {"zeal", 0, 1, {{"little", {0, 0, 0.2, 0.8}}, {"much", {0.2, 0.8, 1, 1}}}}};
    system.outputs = {{"viscosity", 0, 5, {{"thin", {0, 0, 1, 2}}, {"thick", {1, 4, 5, 5}}}},
                      {"mass", 0, 1, {{"light", {0, 0, 0.2, 1}}, {"heavy", {0.2, 0.8, 1, 1}}}}};
    for (const char* rule : {"IF age IS old AND zeal IS much THEN viscosity IS thick AND mass IS heavy",
                             "IF NOT (age IS young OR zeal IS little) THEN viscosity IS thin WITH 0.5",
                             "IF zeal IS little THEN mass IS light", "IF age IS grown THEN mass IS heavy"})
        system.rules.push_back(parseRule(system, rule));
    return system;
}

std::vector<std::string> texts(const FuzzySystem& system) {
    std::vector<std::string> texts;
    for (const FuzzyRule& rule : system.rules)
        texts.push_back(ruleText(system, rule));
    return texts;
}

std::string complaint(const std::function<FuzzySystem()>& edit) {
    try {
        edit();
        return "accepted";
    } catch (const InvalidModel& error) {
        return error.what();
    }
}

/// By name, so that the order does not count.
std::vector<std::pair<std::string, std::optional<double>>> inferred(const FuzzySystem& system,
                                                                    const NamedValues& inputs) {
    const auto values = infer(system, orderedInputs(system, inputs)).outputs;
    std::vector<std::pair<std::string, std::optional<double>>> named;
    for (std::size_t i = 0; i < values.size(); ++i)
        named.emplace_back(system.outputs[i].name, values[i]);
    std::sort(named.begin(), named.end());
    return named;
}

} // namespace

TEST(SystemEdits, RulesFollowNewNames) {
    FuzzySystem system = withTermRenamed(threeRules(), age, 2, "aged");
    system = withVariableRenamed(system, viscosity, "damping");
    EXPECT_EQ(texts(system)[0], "IF age IS aged AND zeal IS much THEN damping IS thick AND mass IS heavy");
    EXPECT_EQ(withTermRenamed(system, age, 2, "aged"), system) << "its own name";
}

TEST(SystemEdits, NamesThatAreTakenOrCannotStandInARuleAreRefused) {
    const FuzzySystem system = threeRules();
    const auto term = [&](const std::string& name) {
        return complaint([&] { return withTermRenamed(system, age, 2, name); });
    };
    EXPECT_EQ(term("young"), "\"age\" has a term \"young\" already");
    EXPECT_EQ(term("thin"), "accepted") << "of another variable";
    EXPECT_EQ(term(""), "the name is missing");
    EXPECT_THAT(term("very old"), HasSubstr("one word"));
    EXPECT_THAT(term("not"), HasSubstr("words of rules"));
    EXPECT_EQ(complaint([&] { return withVariableRenamed(system, age, "mass"); }),
              "there is a variable \"mass\" already");
}

TEST(SystemEdits, ATypedNameBecomesOneWord) {
    EXPECT_EQ(ruleName("  very  soft "), "very_soft");
    EXPECT_EQ(ruleName("weich-ä"), "weich-ä");
    EXPECT_EQ(ruleName("  "), "");
}

TEST(SystemEdits, RulesMeanTheSameInAnyOrder) {
    std::mt19937 random(7);
    const FuzzySystem before = threeRules();
    FuzzySystem system = before;
    for (int i = 0; i < 60; ++i) {
        const auto side = random() % 2 ? FuzzySide::Inputs : FuzzySide::Outputs;
        const std::size_t variables = variablesOf(system, side).size();
        const VariablePlace place{side, random() % variables};
        const std::size_t terms = variableAt(system, place).terms.size();
        system = random() % 2 ? withTermMoved(system, place, random() % terms, random() % terms)
                              : withVariableMoved(system, place, random() % variables);
        ASSERT_THAT(validate(system), IsEmpty());
        const NamedValues inputs{{"age", 0.9 * static_cast<double>(random() % 11)},
                                 {"zeal", 0.1 * static_cast<double>(random() % 11)}};
        ASSERT_EQ(inferred(system, inputs), inferred(before, inputs));
    }
    EXPECT_FALSE(system == before);
    EXPECT_THAT(withTermMoved(before, age, 0, 2).inputs[0].terms,
                ElementsAre(testing::Field(&FuzzyTerm::name, "grown"),
                            testing::Field(&FuzzyTerm::name, "old"),
                            testing::Field(&FuzzyTerm::name, "young")));
}

TEST(SystemEdits, ATermComesWhereThereIsMostRoom) {
    const AddedTerm added = withTermAdded(threeRules(), age);
    EXPECT_EQ(added.term, 2U);
    const FuzzyTerm& term = added.system.inputs[0].terms[2];
    EXPECT_EQ(term.name, "new");
    EXPECT_EQ(term.set.a, 5);
    EXPECT_EQ(term.set.d, 9);
    EXPECT_EQ(texts(added.system), texts(threeRules())) << "rules go on to speak of what they spoke of";
    EXPECT_EQ(withTermAdded(added.system, age).system.inputs[0].terms.size(), 5U);
    FuzzySystem full = threeRules();
    full.inputs[0].terms = {{"all", {0, 0, 9, 9}}};
    full.rules.clear();
    EXPECT_EQ(withTermAdded(full, age).term, 1U);
}

TEST(SystemEdits, RulesThatSpeakOfATermGoWithIt) {
    const FuzzySystem system = threeRules();
    EXPECT_THAT(rulesGoingWith(system, age, 0), ElementsAre(1));
    EXPECT_THAT(texts(withoutTerm(system, age, 0)),
                ElementsAre("IF age IS old AND zeal IS much THEN viscosity IS thick AND mass IS heavy",
                            "IF zeal IS little THEN mass IS light", "IF age IS grown THEN mass IS heavy"));
    const VariablePlace mass{FuzzySide::Outputs, 1};
    EXPECT_THAT(rulesGoingWith(system, mass, 1), ElementsAre(3)) << "the first concludes something else too";
    EXPECT_THAT(texts(withoutTerm(system, mass, 1)),
                ElementsAre("IF age IS old AND zeal IS much THEN viscosity IS thick",
                            "IF NOT (age IS young OR zeal IS little) THEN viscosity IS thin WITH 0.5",
                            "IF zeal IS little THEN mass IS light"));
}

TEST(SystemEdits, RulesThatSpeakOfAVariableGoWithIt) {
    const FuzzySystem system = threeRules();
    EXPECT_THAT(rulesGoingWith(system, age), ElementsAre(0, 1, 3));
    EXPECT_THAT(texts(withoutVariable(system, age)), ElementsAre("IF zeal IS little THEN mass IS light"));
    EXPECT_THAT(texts(withoutVariable(system, viscosity)),
                ElementsAre("IF age IS old AND zeal IS much THEN mass IS heavy",
                            "IF zeal IS little THEN mass IS light", "IF age IS grown THEN mass IS heavy"));
}

TEST(SystemEdits, TheLastOneStays) {
    FuzzySystem system = withoutVariable(threeRules(), age);
    EXPECT_EQ(complaint([&] { return withoutVariable(system, age); }), "a system has at least one input");
    system = withoutTerm(system, age, 0);
    EXPECT_EQ(complaint([&] { return withoutTerm(system, age, 0); }), "a variable has at least one term");
}

TEST(SystemEdits, AnAddedVariableIsPartedEvenly) {
    FuzzySystem system = withVariableAdded(threeRules(), FuzzySide::Inputs);
    system = withVariableAdded(system, FuzzySide::Outputs);
    EXPECT_EQ(system.inputs.back().name, "variable");
    EXPECT_EQ(system.outputs.back().name, "variable_2");
    EXPECT_EQ(system.inputs.back().terms.size(), 3U);
    EXPECT_EQ(texts(system), texts(threeRules()));
}

TEST(SystemEdits, AFormThatCannotBeEvaluatedIsRefused) {
    FuzzyVariable variable = threeRules().inputs[0];
    variable.terms[1].set = {3, 2, 1, 0};
    EXPECT_THAT(complaint([&] { return withVariable(threeRules(), age, variable); }),
                HasSubstr("the corners must rise"));
}

TEST(SystemEdits, ANewSystemCanBeEvaluatedButSaysNothingYet) {
    const FuzzySystem system = newFuzzySystem("mine");
    EXPECT_THAT(validate(system), IsEmpty());
    EXPECT_THAT(infer(system, {5.0}).outputs, ElementsAre(std::nullopt, std::nullopt));
    EXPECT_EQ(system.outputs[0].unit, "N/m");
}

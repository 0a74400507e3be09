#include "core/exchange/fuzzy/fcl_file.h"
#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/inference.h"
#include "tests/core/fuzzy/random_systems.h"
#include "tests/support/fuzzylite_engine.h"
#include "tests/support/rounds.h"

#include <gtest/gtest.h>

#include <regex>

using namespace esm;

namespace {

constexpr int resolution = 200; // what our FLL asks for

void expectSameOutputs(const FuzzySystem& system, FuzzyliteEngine& one, FuzzyliteEngine& other,
                       const std::vector<double>& inputs) {
    one.process(inputs);
    other.process(inputs);
    const auto outputs = one.outputs(), expected = other.outputs();
    ASSERT_EQ(outputs.size(), expected.size());
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        ASSERT_EQ(outputs[i].has_value(), expected[i].has_value());
        const double range = system.outputs[i].maximum - system.outputs[i].minimum;
        if (!outputs[i]) continue;
        EXPECT_NEAR(*outputs[i], *expected[i], 1e-9 * range) << system.outputs[i].name;
    }
}

/// fuzzylite's FCL differs from that of IEC 61131-7: no remarks in brackets, ACCU with the output, keywords
/// of rules in small letters.
std::string asFuzzyliteReadsFcl(std::string text) {
    text = std::regex_replace(text, std::regex(R"(\(\*[^*]*\*\))"), "");
    std::smatch accumulation;
    std::regex_search(text, accumulation, std::regex("  ACCU : \\w+;\n"));
    const std::string line = accumulation.str();
    text.erase(text.find(line), line.size());
    text = std::regex_replace(text, std::regex("END_DEFUZZIFY"), line + "END_DEFUZZIFY");
    std::size_t rules = text.find("  RULE ");
    if (rules == text.npos) return text;
    std::string block = text.substr(rules);
    const std::vector<std::pair<std::string, std::string>> keywords{
        {"IF", "if"}, {"IS", "is"},     {"NOT", "not"},  {"AND", "and"},
        {"OR", "or"}, {"THEN", "then"}, {"WITH", "with"}};
    for (const auto& [keyword, small] : keywords)
        block = std::regex_replace(block, std::regex("\\b" + keyword + "\\b"), small);
    return text.substr(0, rules) + block;
}

std::vector<double> somewhereWithin(const FuzzySystem& system, double part) {
    std::vector<double> inputs;
    for (const FuzzyVariable& input : system.inputs)
        inputs.push_back(input.minimum + part * (input.maximum - input.minimum));
    return inputs;
}

} // namespace

TEST(FllFile, LoadsInFuzzyliteWithEqualOutputs) {
    RandomSystems systems(seedOf(11));
    for (int trial = 0; trial < roundsOf(100, 5000); ++trial) {
        const FuzzySystem system = systems.next();
        FuzzyliteEngine loaded = FuzzyliteEngine::fromFll(toFll(system).text);
        FuzzyliteEngine built(system, resolution);
        expectSameOutputs(system, loaded, built, systems.inputs(system));
    }
}

TEST(FclFile, LoadsInFuzzyliteWithEqualOutputs) {
    RandomSystems systems(seedOf(12));
    for (int trial = 0; trial < roundsOf(50, 2500); ++trial) {
        const FuzzySystem system = systems.next();
        FuzzyliteEngine loaded =
            FuzzyliteEngine::fromFcl(asFuzzyliteReadsFcl(toFcl(system).text), resolution);
        FuzzyliteEngine built(system, resolution);
        expectSameOutputs(system, loaded, built, systems.inputs(system));
    }
}

TEST(FuzzyFiles, OfThePresetsGiveInFuzzyliteWhatWeInfer) {
    for (const std::string& name : fuzzyPresetNames()) {
        const FuzzySystem system = fuzzyPreset(name);
        FuzzyliteEngine fll = FuzzyliteEngine::fromFll(toFll(system).text);
        FuzzyliteEngine fcl = FuzzyliteEngine::fromFcl(asFuzzyliteReadsFcl(toFcl(system).text), resolution);
        for (const double part : {0.0, 0.37, 1.0}) { // shoulders hold at the ends of the range too
            const std::vector<double> inputs = somewhereWithin(system, part);
            expectSameOutputs(system, fll, fcl, inputs);
            const InferenceResult result = infer(system, {inputs.begin(), inputs.end()});
            for (std::size_t i = 0; i < result.outputs.size(); ++i) {
                ASSERT_EQ(result.outputs[i].has_value(), fll.outputs()[i].has_value());
                const double range = system.outputs[i].maximum - system.outputs[i].minimum;
                if (!result.outputs[i]) continue;
                EXPECT_NEAR(*result.outputs[i], *fll.outputs()[i], 1e-3 * range);
            }
        }
    }
}

TEST(FllFile, SaysNotBeforeBracketsInAWayThatFuzzyliteReads) {
    FuzzySystem system = fuzzyPreset("robo-sim");
    FuzzyCondition either = disjunction({{{0, 3}}, conjunction({{{1, 1}}, negation({{2, 0}})})});
    system.rules = {FuzzyRule{negation(either), {{0, 2}}}};
    FuzzyliteEngine engine = FuzzyliteEngine::fromFll(toFll(system).text);
    const std::vector<double> inputs = somewhereWithin(system, 0.3);
    engine.process(inputs);
    EXPECT_NEAR(engine.outputs()[0].value(), infer(system, {inputs.begin(), inputs.end()}).outputs[0].value(),
                0.1);
    EXPECT_TRUE(toFll(system).warnings.empty());
    system.norms.disjunction = TConorm::BoundedSum;
    EXPECT_EQ(toFll(system).warnings.size(), 1);
}

TEST(FllFile, HasSinglePointsAveragedByFuzzylite) {
    FuzzySystem system;
    system.inputs = {{"x", 0, 1, {{"low", {0, 0, 0, 1}}, {"high", {0, 1, 1, 1}}}}};
    system.outputs = {{"y", 0, 10, {{"small", {2, 2, 2, 2}}, {"large", {8, 8, 8, 8}}}}};
    system.rules = {FuzzyRule{{{0, 0}}, {{0, 0}}}, FuzzyRule{{{0, 1}}, {{0, 1}}}};
    FuzzyliteEngine engine = FuzzyliteEngine::fromFll(toFll(system).text);
    engine.process({0.25});
    EXPECT_NEAR(engine.outputs()[0].value(), 3.5, 1e-12);
    EXPECT_NEAR(infer(system, {0.25}).outputs[0].value(), 3.5, 1e-12);
}

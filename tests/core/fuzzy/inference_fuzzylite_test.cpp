#include "core/fuzzy/inference.h"

#include "core/exchange/fuzzy/fll_file.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/rule_text.h"
#include "tests/core/fuzzy/random_systems.h"
#include "tests/support/fuzzylite_engine.h"
#include "tests/support/rounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace esm;

namespace {

/// Of the rules that speak of an output.
struct Firing {
    double highest = 0;
    double conclusions = 0;
};

Firing firingFor(const FuzzySystem& system, const InferenceResult& result, std::size_t output) {
    Firing firing;
    for (std::size_t rule = 0; rule < system.rules.size(); ++rule)
        for (const FuzzyProposition& conclusion : system.rules[rule].conclusions)
            if (conclusion.variable == output) {
                firing.highest = std::max(firing.highest, result.firing[rule]);
                ++firing.conclusions;
            }
    return firing;
}

} // namespace

TEST(Inference, AgreesWithFuzzyliteOnRandomSystems) {
    constexpr int resolution = 10000;
    constexpr double cell = 1.0 / resolution; // as a part of the range
    constexpr double rounding = 1e-12;        // what fires no more, one of the two may take for nothing
    RandomSystems systems(seedOf(4));
    int compared = 0;
    for (int trial = 0; trial < roundsOf(1000, 20000); ++trial) {
        const FuzzySystem system = systems.next();
        ASSERT_TRUE(validate(system).empty());
        const std::vector<double> inputs = systems.inputs(system);
        FuzzyliteEngine engine(system, resolution);
        engine.process(inputs);
        const std::vector<std::optional<double>> expected = engine.outputs();
        const InferenceResult result = infer(system, {inputs.begin(), inputs.end()});
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const std::string what = "system " + std::to_string(trial) + ", output " + std::to_string(i);
            const Firing firing = firingFor(system, result, i);
            if (firing.highest > 0 && firing.highest < rounding) continue;
            ASSERT_EQ(result.outputs[i].has_value(), expected[i].has_value()) << what;
            if (!expected[i]) continue;
            // Taking the middle of a cell for all of it errs by an eighth of its width squared times the bend
            // within it; there are four bends to a set, each no sharper than its slope. In all of the area
            // that is at least the highest degree times the RandomSystems::narrowest core.
            const double slope = 1 / RandomSystems::narrowest,
                         area = firing.highest * RandomSystems::narrowest;
            const double tolerance = 4 * firing.conclusions * slope * cell * cell / 8 / area;
            const double range = system.outputs[i].maximum - system.outputs[i].minimum;
            EXPECT_NEAR(*result.outputs[i], *expected[i], tolerance * range) << what;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

bool isOfPoints(const FuzzyVariable& output) {
    return std::all_of(output.terms.begin(), output.terms.end(),
                       [](const FuzzyTerm& term) { return term.set.a == term.set.d; });
}

TEST(Inference, AgreesWithFuzzyliteOnThePresets) {
    for (const std::string& name : fuzzyPresetNames()) {
        const FuzzySystem system = fuzzyPreset(name);
        // Of points alone it takes the mean by their weights, which its own language has to tell it.
        FuzzyliteEngine engine = isOfPoints(system.outputs[0]) ? FuzzyliteEngine::fromFll(toFll(system).text)
                                                               : FuzzyliteEngine(system, 20000);
        std::vector<double> inputs;
        for (const FuzzyVariable& input : system.inputs)
            inputs.push_back(input.minimum + 0.37 * (input.maximum - input.minimum));
        engine.process(inputs);
        const InferenceResult result = infer(system, {inputs.begin(), inputs.end()});
        for (std::size_t i = 0; i < result.outputs.size(); ++i) {
            const FuzzyVariable& output = system.outputs[i];
            EXPECT_NEAR(result.outputs[i].value(), engine.outputs()[i].value(),
                        1e-6 * (output.maximum - output.minimum))
                << name << ", " << output.name;
        }
    }
}

#include "core/fuzzy/inference.h"

#include "core/exchange/fuzzy_file.h"
#include "core/fuzzy/rule_text.h"
#include "tests/support/fuzzylite_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace esm;

namespace {

/// Every slope and every core is at least this part of its variable's range wide.
constexpr double narrowest = 0.1;

/// Sound systems of every kind, from plain to crowded.
class RandomSystems {
public:
    explicit RandomSystems(unsigned seed) : m_random(seed) {}

    FuzzySystem next() {
        FuzzySystem system;
        for (std::size_t i = 0, count = upTo(3); i < count; ++i)
            system.inputs.push_back(variable("in" + std::to_string(i)));
        for (std::size_t i = 0, count = upTo(2); i < count; ++i)
            system.outputs.push_back(variable("out" + std::to_string(i)));
        for (std::size_t i = 0, count = 1 + upTo(5); i < count; ++i) {
            FuzzyRule rule{condition(system.inputs, 2), {proposition(system.outputs)}};
            if (upTo(2) == 1) rule.conclusions.push_back(proposition(system.outputs));
            if (upTo(2) == 1) rule.weight = uniform(0, 1);
            system.rules.push_back(rule);
        }
        system.norms = {static_cast<TNorm>(upTo(3) - 1), static_cast<TConorm>(upTo(3) - 1),
                        static_cast<TNorm>(upTo(3) - 1), static_cast<TConorm>(upTo(3) - 1)};
        return system;
    }

    std::vector<double> inputs(const FuzzySystem& system) {
        std::vector<double> values;
        for (const FuzzyVariable& input : system.inputs)
            values.push_back(uniform(input.minimum, input.maximum));
        return values;
    }

private:
    std::size_t upTo(std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(1, most)(m_random);
    }
    double uniform(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(m_random);
    }

    FuzzyVariable variable(const std::string& name) {
        const double minimum = uniform(-100, 100), range = uniform(1, 100);
        FuzzyVariable result{name, minimum, minimum + range, {}};
        for (std::size_t i = 0, count = 1 + upTo(3); i < count; ++i) {
            const double b = minimum + range * uniform(0, 1 - narrowest);
            const double c = b + range * uniform(narrowest, 1 - (b - minimum) / range);
            result.terms.push_back(
                {"t" + std::to_string(i),
                 {b - range * uniform(narrowest, 0.5), b, c, c + range * uniform(narrowest, 0.5)}});
        }
        return result;
    }

    FuzzyProposition proposition(const std::vector<FuzzyVariable>& variables) {
        const std::size_t variable = upTo(variables.size()) - 1;
        return {variable, upTo(variables[variable].terms.size()) - 1};
    }

    FuzzyCondition condition(const std::vector<FuzzyVariable>& inputs, int levels) {
        const FuzzyCondition leaf{proposition(inputs)};
        switch (levels > 0 ? upTo(4) : upTo(2)) {
        case 1:
            return leaf;
        case 2:
            return negation(leaf);
        case 3:
            return conjunction({condition(inputs, levels - 1), condition(inputs, levels - 1)});
        default:
            return disjunction({condition(inputs, levels - 1), condition(inputs, levels - 1)});
        }
    }

    std::mt19937 m_random;
};

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
    RandomSystems systems(4);
    int compared = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const FuzzySystem system = systems.next();
        ASSERT_TRUE(validate(system).empty());
        const std::vector<double> inputs = systems.inputs(system);
        FuzzyliteEngine engine(system, resolution);
        engine.process(inputs);
        const std::vector<std::optional<double>> expected = engine.outputs();
        const InferenceResult result = infer(system, {inputs.begin(), inputs.end()});
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const std::string what = "system " + std::to_string(trial) + ", output " + std::to_string(i);
            ASSERT_EQ(result.outputs[i].has_value(), expected[i].has_value()) << what;
            if (!expected[i]) continue;
            // Taking the middle of a cell for all of it errs by an eighth of its width squared times the bend
            // within it; there are four bends to a set, each no sharper than its slope. In all of the area
            // that is at least the highest degree times the narrowest core.
            const Firing firing = firingFor(system, result, i);
            const double slope = 1 / narrowest, area = firing.highest * narrowest;
            const double tolerance = 4 * firing.conclusions * slope * cell * cell / 8 / area;
            const double range = system.outputs[i].maximum - system.outputs[i].minimum;
            EXPECT_NEAR(*result.outputs[i], *expected[i], tolerance * range) << what;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(Inference, AgreesWithFuzzyliteOnThePresets) {
    for (const std::string& name : fuzzyPresetNames()) {
        const FuzzySystem system = fuzzyPreset(name);
        FuzzyliteEngine engine(system, 100000);
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

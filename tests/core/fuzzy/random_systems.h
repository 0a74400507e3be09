#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <cstddef>
#include <random>
#include <string>
#include <vector>

/// Sound systems of every kind, from plain to crowded.
class RandomSystems {
public:
    /// Every slope and every core is at least this part of its variable's range wide.
    static constexpr double narrowest = 0.1;

    explicit RandomSystems(unsigned seed) : m_random(seed) {}

    esm::FuzzySystem next() {
        esm::FuzzySystem system;
        for (std::size_t i = 0, count = upTo(3); i < count; ++i)
            system.inputs.push_back(variable("in" + std::to_string(i)));
        for (std::size_t i = 0, count = upTo(2); i < count; ++i)
            system.outputs.push_back(variable("out" + std::to_string(i)));
        for (std::size_t i = 0, count = 1 + upTo(5); i < count; ++i) {
            esm::FuzzyRule rule{condition(system.inputs, 2), {proposition(system.outputs)}};
            if (upTo(2) == 1) rule.conclusions.push_back(proposition(system.outputs));
            if (upTo(2) == 1) rule.weight = uniform(0, 1);
            system.rules.push_back(rule);
        }
        system.norms = {static_cast<esm::TNorm>(upTo(3) - 1), static_cast<esm::TConorm>(upTo(3) - 1),
                        static_cast<esm::TNorm>(upTo(3) - 1), static_cast<esm::TConorm>(upTo(3) - 1)};
        return system;
    }

    std::vector<double> inputs(const esm::FuzzySystem& system) {
        std::vector<double> values;
        for (const esm::FuzzyVariable& input : system.inputs)
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

    esm::FuzzyVariable variable(const std::string& name) {
        const double minimum = uniform(-100, 100), range = uniform(1, 100);
        esm::FuzzyVariable result{name, minimum, minimum + range, {}};
        for (std::size_t i = 0, count = 1 + upTo(3); i < count; ++i) {
            const double b = minimum + range * uniform(0, 1 - narrowest);
            const double c = b + range * uniform(narrowest, 1 - (b - minimum) / range);
            result.terms.push_back(
                {"t" + std::to_string(i),
                 {b - range * uniform(narrowest, 0.5), b, c, c + range * uniform(narrowest, 0.5)}});
        }
        return result;
    }

    esm::FuzzyProposition proposition(const std::vector<esm::FuzzyVariable>& variables) {
        const std::size_t variable = upTo(variables.size()) - 1;
        return {variable, upTo(variables[variable].terms.size()) - 1};
    }

    esm::FuzzyCondition condition(const std::vector<esm::FuzzyVariable>& inputs, int levels) {
        const esm::FuzzyCondition leaf{proposition(inputs)};
        switch (levels > 0 ? upTo(4) : upTo(2)) {
        case 1:
            return leaf;
        case 2:
            return esm::negation(leaf);
        case 3:
            return esm::conjunction({condition(inputs, levels - 1), condition(inputs, levels - 1)});
        default:
            return esm::disjunction({condition(inputs, levels - 1), condition(inputs, levels - 1)});
        }
    }

    std::mt19937 m_random;
};

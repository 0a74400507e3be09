#pragma once

#include "core/fuzzy/inference.h"

/// One output "y" with these sets, and an input and a rule for each; inputs of 0 fire the rules to the
/// degrees.
inline esm::FuzzySystem degreeSystem(const std::vector<esm::Trapezoid>& outputs,
                                     const std::vector<double>& degrees) {
    esm::FuzzySystem system;
    system.outputs = {{"y", -100, 100, {}}};
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string name = "t" + std::to_string(i);
        system.inputs.push_back(
            {"x" + std::to_string(i), -1, 1, {{"s", {-degrees[i], 1 - degrees[i], 9, 9}}}});
        system.outputs[0].terms.push_back({name, outputs[i]});
        system.rules.push_back({{{i, 0}}, {{0, i}}});
    }
    return system;
}

/// Output "y" where every input is 0.
inline std::optional<double> centreOf(const esm::FuzzySystem& system) {
    return esm::infer(system, std::vector<std::optional<double>>(system.inputs.size(), 0.0)).outputs[0];
}

#pragma once

#include "core/fuzzy/rule_text.h"

/// Inputs "age" (young, old) and "zeal" (little, much), outputs "viscosity" (thin, thick) and "mass" (small).
inline esm::FuzzySystem ageAndZealSystem(const std::vector<std::string>& rules = {}) {
    esm::FuzzySystem system;
    system.inputs = {{"age", 0, 9, {{"young", {0, 0, 2, 4}}, {"old", {2, 4, 9, 9}}}},
                     {"zeal", 0, 1, {{"little", {0, 0, 0.2, 0.8}}, {"much", {0.2, 0.8, 1, 1}}}}};
    system.outputs = {{"viscosity", 0, 5, {{"thin", {0, 0, 1, 2}}, {"thick", {3, 4, 5, 5}}}},
                      {"mass", 0, 1, {{"small", {0, 0, 1, 1}}}}};
    for (const std::string& rule : rules)
        system.rules.push_back(esm::parseRule(system, rule));
    return system;
}

#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace esm {

/// Values by variable name, in any order.
using NamedValues = std::vector<std::pair<std::string, double>>;

struct InferenceResult {
    std::vector<std::optional<double>> outputs; ///< in the system's order; empty where no rule fires
    std::vector<double> firing;                 ///< degree per rule, 0 to 1
};

/// Mamdani inference by the system's norms [R 2.48, 2.49], then the exact centre of gravity of each output.
/// `inputs` are in the system's order. One that is missing or not a number is unknown. So is every condition
/// that asks for it, whatever else it says, and its rule does not fire. Inputs out of range are evaluated
/// unclamped. Preconditions: the system is valid, there are as many inputs as it has. Does not throw.
InferenceResult infer(const FuzzySystem& system, const std::vector<std::optional<double>>& inputs);

/// Puts named values into the system's order. @throws InvalidModel naming every unknown or non-finite one
std::vector<std::optional<double>> orderedInputs(const FuzzySystem& system, const NamedValues& values);

/// "flexible 0.92, medium 0.08": the terms a value belongs to, strongest first.
std::string inWords(const FuzzyVariable& variable, double value);

} // namespace esm

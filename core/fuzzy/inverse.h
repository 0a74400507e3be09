#pragma once

#include "core/fuzzy/inference.h"

namespace esm {

/// An input and the value at which an output comes to what is wanted.
struct ReachingInput {
    std::size_t input;
    double value;
};

/// Turns inference round: which input, moved within its range while the others stay, brings an output to a
/// value; the first in the system's order that does, and the least such value. None where no input reaches
/// it. Preconditions: those of infer(); the output is one of the system's.
std::optional<ReachingInput> reachingInput(const FuzzySystem& system,
                                           const std::vector<std::optional<double>>& inputs,
                                           std::size_t output, double wanted);

} // namespace esm

#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// A slider's move on 10 k nodes, from the new model until the next step can be taken: against a simulation
/// made anew, against the factorisations that it cannot do without, and against a step.
std::vector<Ratio> registerSliderMove();

} // namespace benchmarks

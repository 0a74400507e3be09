#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// The explicit step on closed surfaces of 642 to 655 362 nodes: against a naive loop, against the bandwidth
/// of the memory, shuffled against ordered, and by threads.
std::vector<Ratio> registerExplicitStep();

} // namespace benchmarks

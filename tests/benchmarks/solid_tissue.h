#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// Lattices that fill a ball against nets of as many nodes: set-up, steps, a slider's move, a first touch.
std::vector<Ratio> registerSolidTissue();

} // namespace benchmarks

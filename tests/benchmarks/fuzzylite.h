#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// fuzzylite's sampled inference to our exact one, on the published system of 14 rules.
std::vector<Ratio> registerFuzzylite();

} // namespace benchmarks

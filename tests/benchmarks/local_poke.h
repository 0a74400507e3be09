#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// A short force on one node of 202 500: steps that leave out what rests against whole ones.
std::vector<Ratio> registerLocalPoke();

} // namespace benchmarks

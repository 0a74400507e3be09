#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// Each layout of a texture against the source's rows.
std::vector<Ratio> registerAtlasPacking();

} // namespace benchmarks

#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// Eight layers composed anew into 4096² texels, and one of them moved, against a plain loop over the same
/// texels.
std::vector<Ratio> registerLayerComposition();

} // namespace benchmarks

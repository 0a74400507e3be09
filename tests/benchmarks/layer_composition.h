#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// One and eight layers composed into 4096² texels against a plain scalar loop, on one thread and two, one of
/// eight changed against all composed, and the memory that it takes against that of the page.
std::vector<Ratio> registerLayerComposition();

} // namespace benchmarks

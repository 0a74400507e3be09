#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// A simulated second of the published tube and ventricle, and of a membrane with strong viscosity: the
/// methods made for them against a naive loop at its own limit.
std::vector<Ratio> registerStiffTissue();

} // namespace benchmarks

#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// After a slider's move on 10 k nodes: choosing the step, and finding the critical one, beside a
/// factorisation.
std::vector<Ratio> registerCriticalStep();

} // namespace benchmarks

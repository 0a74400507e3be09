#pragma once

#include "tests/benchmarks/ratios.h"

namespace benchmarks {

/// Bullet's soft body, per step of the same springs, and where it is as accurate as it gets.
std::vector<Ratio> registerBullet();

} // namespace benchmarks

#pragma once

#include "core/dynamics/measure/measured_runs.h"

#include <string>

namespace esm {

/// A line for each run, under a line of names: integrator, precision, step (s), nodes, whether it ended,
/// error relative to the motion and whether it is that or less, wall time per simulated second (s), times
/// real time, and whether no other run is both as fast and as exact. What a run that did not end lacks stays
/// empty.
std::string measuredRunsCsv(const Tradeoff& tradeoff);

} // namespace esm

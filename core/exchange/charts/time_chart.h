#pragma once

#include "core/exchange/charts/drawing.h"
#include "core/probing/probe.h"

#include <string>
#include <vector>

namespace esm {

/// What followed a finger in time, under the name that the chart calls it by.
struct NamedTimeCurve {
    std::string name;
    TimeCurve curve;
};

/// Force (N) over time (s) of fingers that stay at a depth, from when they stand on. A line across marks when
/// 1/e of the way to the end is left.
Drawing relaxationChart(const std::vector<NamedTimeCurve>& tests);
/// Depth (mm) over time (s) of fingers under a force, marked alike.
Drawing creepChart(const std::vector<NamedTimeCurve>& tests);

/// A line for each point of each curve, under a line of names: name, time (s), depth (m), force (N).
std::string timeCsv(const std::vector<NamedTimeCurve>& tests);

} // namespace esm

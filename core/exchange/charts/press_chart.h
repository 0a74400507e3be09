#pragma once

#include "core/exchange/charts/drawing.h"
#include "core/probing/probe.h"

#include <string>
#include <vector>

namespace esm {

/// What a finger measured, under the name that the chart calls it by.
struct NamedPress {
    std::string name;
    std::vector<PressPoint> curve;
};

/// Force (N) over depth (mm), a line with dots for each curve.
Drawing pressChart(const std::vector<NamedPress>& presses);

/// A line for each point of each curve, under a line of names: name, depth (m), force (N).
std::string pressCsv(const std::vector<NamedPress>& presses);

} // namespace esm

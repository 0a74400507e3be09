#pragma once

#include "core/exchange/charts/drawing.h"
#include "core/probing/strip.h"

#include <string>
#include <vector>

namespace esm {

/// What a strip told, under the name that the chart calls it by.
struct NamedStrip {
    std::string name;
    std::vector<StripPoint> curve;
};

/// Force (N) over elongation (mm), a line with dots for each curve.
Drawing stripChart(const std::vector<NamedStrip>& strips);

/// A line for each point of each curve, under a line of names: name, elongation (m), strain, force (N).
std::string stripCsv(const std::vector<NamedStrip>& strips);

} // namespace esm

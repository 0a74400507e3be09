#pragma once

#include "core/texture/atlas/charts/flattening.h"

namespace esm {

/// Whether a closed line, counter-clockwise around a chart, neither crosses itself nor comes nearer to itself
/// than `clearance` across what is outside of it. Where it turns a corner it is near to itself, as the
/// surface is: what is at most `mostDetour` times as far along the line as straight through counts as that.
bool keepsClear(const PlanePoints& border, double clearance);

constexpr double mostDetour = 6;

} // namespace esm

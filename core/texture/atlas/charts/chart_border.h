#pragma once

#include "core/texture/atlas/charts/flattening.h"

namespace esm {

/// Whether a closed line, counter-clockwise around a chart, neither crosses itself nor comes nearer to itself
/// than `clearance` across what is outside of it. Around a corner it may: there the way along the line is at
/// most `mostDetour` times the straight one.
bool keepsClear(const PlanePoints& border, double clearance);

constexpr double mostDetour = 6;

} // namespace esm

#pragma once

#include "core/dynamics/measure/tradeoff.h"
#include "core/exchange/charts/drawing.h"

namespace esm {

/// Error over speed, both logarithmic: one dot for each stable run, hollow for single precision, a line
/// through those that none beats, rings around the recommended ones, lines at the wishes. What has no place
/// on a logarithmic axis is left out. Methods are called by their titles.
Drawing tradeoffChart(const Tradeoff& tradeoff, const TradeoffWishes& wishes);

} // namespace esm

#pragma once

#include "core/dynamics/measure/tradeoff.h"
#include "core/exchange/charts/drawing.h"

namespace esm {

/// Error over wall time per simulated second, both logarithmic: one dot for each stable run, filled for
/// double precision, a line through those that none beats, rings around the recommended ones, lines at the
/// wishes.
Drawing tradeoffChart(const Tradeoff& tradeoff, const TradeoffWishes& wishes);

} // namespace esm

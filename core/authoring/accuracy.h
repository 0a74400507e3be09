#pragma once

#include "core/dynamics/measure/tradeoff.h"
#include "core/project/project.h"

namespace esm {

/// What speed and accuracy are measured on: the project's own scene; where nothing in it moves the tissue, a
/// second in which a patch at the organ's edge is drawn outwards and held.
/// @throws InvalidModel when every node is fixed
Scene measuredScene(const Project& project);

/// Measures every way to step the project's tissue, on all its nodes and on fewer. Seconds for a small organ,
/// minutes for a large one.
/// @throws InvalidModel; Cancelled
Tradeoff measureAccuracy(const Project& project, const TradeoffOptions& options, const Progress& progress);

} // namespace esm

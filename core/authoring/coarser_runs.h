#pragma once

#include "core/dynamics/measure/tradeoff.h"
#include "core/project/project.h"

namespace esm {

/// A scene of a project on a quarter of its nodes, a sixteenth and so on, to be measured against the whole.
/// Each shows the recorded nodes where it carries the drawn vertices that are there. None for what moves
/// rigidly or is split, and where a recorded node shows at no vertex. @throws Cancelled, between two of them
std::vector<CoarserRun> coarserRuns(const Project& project, const Scene& scene,
                                    const Progress& progress = {});

/// The project with a measured run as the way to step it that is recommended, on the nodes of that run.
/// @throws InvalidModel when the surface has no such level of detail; Cancelled
Project withRun(const Project& project, const TradeoffRun& run, const Progress& progress = {});

} // namespace esm

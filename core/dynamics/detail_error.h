#pragma once

#include "core/dynamics/settings.h"
#include "core/model/project.h"
#include "core/support/progress.h"

namespace esm {

/// What a level of detail costs in accuracy: runs the project's own scene as it is and at that level, in the
/// same steps, and compares where the nodes carry the drawn vertices at the recorded times.
/// @throws InvalidModel when the surface has no such level, or one of the runs does not end as it should;
/// Cancelled
double detailError(const Project& project, const Detail& detail, const SimulationSettings& settings = {},
                   const Progress& progress = {});

} // namespace esm

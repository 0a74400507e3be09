#pragma once

#include "core/dynamics/statics/pressed_tissue.h"
#include "core/probing/probe.h"

namespace esm {

/// Presses tissue that is at rest to so many depths one after the other, evenly apart. From (0, 0) on.
std::vector<PressPoint> pressCurve(PressedTissue& tissue, double depth, int steps, const Progress& progress);

} // namespace esm

#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// Whether any hinge is bent at rest, by more than the rounding of meshes in single precision.
bool isCurvedAtRest(const SpringSystem& system);

} // namespace esm

#pragma once

#include "core/dynamics/simulation.h"

#include <algorithm>

namespace esm {

/// Whether an instrument has touched what can move since the start.
inline bool wasTouched(const Simulation& simulation) {
    const auto& touches = simulation.instrumentTouches();
    return std::any_of(touches.begin(), touches.end(), [](const auto& touch) { return touch.touched; });
}

} // namespace esm

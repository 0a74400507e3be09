#pragma once

#include "core/dynamics/stability/stability.h"
#include "core/samples/samples.h"

namespace esm {

inline Project refusedProject() {
    Project project = makeSample("tube");
    project.base.mass = -1;
    return project;
}

/// To be stepped by Euler steps of so many times the longest stable one.
inline Project steppedTooLong(double factor) {
    Project tube = makeSample("tube");
    const double longest = *criticalStep(evaluateModel(tube), Integrator::Euler);
    tube.stepping = {{Integrator::Euler, factor * longest, Precision::Double}, 0.01, 1};
    return tube;
}

} // namespace esm

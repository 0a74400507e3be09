#pragma once

#include "core/dynamics/simulation.h"

/// @param step s
inline esm::SimulationSettings withStep(esm::Integrator integrator, double step) {
    esm::SimulationSettings settings;
    settings.integrator = integrator;
    settings.timeStep = step;
    return settings;
}

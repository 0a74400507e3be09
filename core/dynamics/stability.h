#pragma once

#include "core/dynamics/simulation.h"

namespace esm {

/// Largest stable steps, s, without a safety factor; empty where there is no stable step, infinite where there is
/// no limit. Valid for any deformation: elasticity is bounded by its weighted graph Laplacian.
struct CriticalSteps {
    double omegaMax = 0; ///< largest undamped angular frequency, 1/s
    std::optional<double> euler, split, split2;
};

CriticalSteps criticalSteps(const TissueModel& model);

/// What `Integrator::Auto` and a missing time step become: `split2` where its conditions hold, else `split`,
/// else `euler`, with a step that keeps a margin to the critical one.
struct ChosenStep {
    Integrator integrator;
    double timeStep; ///< s
};
ChosenStep chooseStep(const TissueModel& model, const SimulationSettings& settings);

} // namespace esm

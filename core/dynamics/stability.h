#pragma once

#include "core/dynamics/simulation.h"

namespace esm {

/// Largest stable steps, s, without a safety factor; empty where there is no stable step, infinite where
/// there is no limit. Valid for any deformation: elasticity is bounded by its weighted graph Laplacian.
struct CriticalSteps {
    double omegaMax = 0; ///< largest undamped angular frequency, 1/s
    std::optional<double> euler, split, split2;
};

/// @throws InvalidModel
CriticalSteps criticalSteps(const TissueModel& model);

/// What `Integrator::Auto` and a missing time step become: `split2` where its conditions hold, else `split`,
/// else `euler`, with a step that keeps a margin to the critical one.
struct ChosenStep {
    Integrator integrator;
    double timeStep; ///< s
};

/// A given time step is taken as given; `Auto` then becomes an integrator that is stable at it, where there
/// is one.
/// @throws InvalidModel when model or settings have problems, or no step of at least 1 ns would be stable
ChosenStep chooseStep(const TissueModel& model, const SimulationSettings& settings);

/// Where one damped oscillator of angular frequency ω and damping d/m is stable under `split2`: (hω)² must
/// stay below this, as a function of h·d/m. Its two branches are where a root of the step leaves the unit
/// circle in a complex pair and at −1; for little damping it is √(2·h·d/m).
double split2Limit(double stepDamping);

} // namespace esm

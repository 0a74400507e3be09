#pragma once

#include "core/dynamics/settings.h"
#include "core/model/tissue_model.h"
#include "core/support/progress.h"

namespace esm {

inline constexpr double longestStep = 0.01;  ///< s; what is chosen stays at or below this
inline constexpr double shortestStep = 1e-9; ///< s; and at or above this

struct StabilitySearch {
    double tolerance = 1e-3; ///< relative; a step is found too short by at most this
    Progress progress;       ///< asked before each factorisation; how many there will be is not known
};

/// Largest stable step, s, of an integrator (not `Auto`), without a safety factor; empty where there is no
/// stable step, infinite where there is no limit. Valid for any deformation: elasticity is bounded by its
/// weighted graph Laplacian.
/// @throws InvalidModel, Cancelled
std::optional<double> criticalStep(const TissueModel& model, Integrator integrator,
                                   const StabilitySearch& search = {});

struct CriticalSteps {
    std::optional<double> euler, split, split2;
};
/// Those of every integrator. @throws InvalidModel
CriticalSteps criticalSteps(const TissueModel& model);

/// What `Integrator::Auto` and a missing time step become: `split2` where its stable step is at least half
/// that of `split`; else `euler` where viscosity is so small that its step is nearly as long; else `split`.
/// The step keeps a margin to the critical one.
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

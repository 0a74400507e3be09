#pragma once

#include "core/dynamics/settings.h"
#include "core/dynamics/spectrum/stability_search.h"
#include "core/model/tissue_model.h"

#include <map>

namespace esm {

struct SpringSystem;

inline constexpr double longestStep = 0.01;  ///< s; what is chosen stays at or below this
inline constexpr double shortestStep = 1e-9; ///< s; and at or above this

/// Largest stable step, s, of an integrator (not `Auto`) that takes the damping, without a safety factor;
/// empty where there is no stable step, as `euler` always has, infinite where there is no limit.
/// @throws InvalidModel, Cancelled
std::optional<double> criticalStep(const TissueModel& model, Integrator integrator,
                                   const StabilitySearch& search = {}, Damping damping = Damping::Isotropic);

using CriticalSteps = std::map<Integrator, std::optional<double>>;
/// Those of every integrator that takes the damping. @throws InvalidModel, Cancelled
CriticalSteps criticalSteps(const TissueModel& model, Damping damping = Damping::Isotropic,
                            const StabilitySearch& search = {});

/// Whether a step is within the limit at any deformation, with isotropic damping. @throws InvalidModel
bool isStable(const TissueModel& model, const Stepping& stepping);

/// Settings that leave integrator, step and precision open, with those that were recommended for the tissue,
/// where they are stable with it as it is now; else the same settings. What was measured is isotropic damping
/// of the whole tissue: other settings stay as they are. @throws InvalidModel
SimulationSettings steppedAsRecommended(const SimulationSettings& settings, const TissueModel& model,
                                        const std::optional<MeasuredStepping>& recommended);

/// Of small oscillations about rest without damping, the largest angular frequency, rad/s.
/// @throws InvalidModel
double largestAngularFrequency(const TissueModel& model);

/// What `Integrator::Auto` and a missing time step become: `split2` where its stable step is at least half
/// that of `split`; else `euler` where viscosity is so small that its step is nearly as long; else `split`.
/// Where these fall behind real time, `bdf2`, in steps as long as its solution is sure to be found,
/// if that is cheaper. The step keeps a margin to the critical one. A given time step is taken as given;
/// `Auto` then becomes an integrator that is stable at it (in float, `euler`).
/// @throws InvalidModel when model or settings have problems, or no step of at least 1 ns would be stable
ChosenStep chooseStep(const TissueModel& model, const SimulationSettings& settings);
ChosenStep chooseStep(const SpringSystem& system, const SimulationSettings& settings);

} // namespace esm

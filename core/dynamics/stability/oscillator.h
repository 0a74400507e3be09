#pragma once

#include "core/model/integrators.h"

namespace esm {

/// One damped oscillator of angular frequency ω under an explicit Runge-Kutta or multistep integrator, in
/// units of the step: stepDamping = h·d/m, stepStiffness = (hω)².
struct StepOscillator {
    double stepDamping, stepStiffness;
};

/// Largest factor by which a step of heun, rk4 or adams-moulton lets the oscillation grow.
double growthFactor(Integrator integrator, const StepOscillator& oscillator);

/// stepStiffness must stay below this for a given stepDamping: the lowest at which heun, rk4 or adams-moulton
/// grow.
double stiffnessLimit(Integrator integrator, double stepDamping);

/// Where pure decay, x' = −r·x, leaves the stable region of heun, rk4 or adams-moulton: h·r.
double decayLimit(Integrator integrator);

/// As stiffnessLimit() for split2. Its two branches are where a root of the step leaves the unit circle in a
/// complex pair and at −1; for little damping it is √(2·h·d/m).
double split2Limit(double stepDamping);

} // namespace esm

#pragma once

#include <complex>

namespace esm {

/// By which an explicit Runge-Kutta or multistep integrator lets y' = z·y grow in a step of length 1, at
/// most.
using Growth = double (*)(std::complex<double> z);

/// One damped oscillator of angular frequency ω, in units of the step: stepDamping = h·d/m,
/// stepStiffness = (hω)².
struct StepOscillator {
    double stepDamping, stepStiffness;
};

/// Largest factor by which a step lets the oscillation grow.
double growthFactor(Growth growth, const StepOscillator& oscillator);

/// stepStiffness must stay below this for a given stepDamping: the lowest at which a step lets it grow.
double stiffnessLimit(Growth growth, double stepDamping);

/// Where pure decay, x' = −r·x, leaves the stable region: h·r.
double decayLimit(Growth growth);

} // namespace esm

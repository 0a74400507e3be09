#include "core/dynamics/schemes/rk4.h"

#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/multistage_limits.h"

#include <cmath>

namespace esm {

namespace {

// The classical Runge-Kutta form [B 4.2]: the slope at the beginning, two in the middle and one at the end,
// weighed 1:2:2:1. Four evaluations, fourth order. It needs no step before it, so that Adams-Moulton starts
// with it.
template<class Real> void rk4Step(ExplicitWork<Real>& work, const StepInput& input) {
    work.computeRates(input, 0, work.state, work.stageRates[0]);
    rungeKuttaStep(work, input, work.stageRates[0]);
}

// The series of e^z as far as the fourth order. On the imaginary axis it stays below 1 up to 2√2, so that
// undamped tissue has stable steps, which it has not by Heun's form.
double rk4Growth(std::complex<double> z) {
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
}

std::optional<double> largestRk4Step(TissueSpectrum& tissue, double cap) {
    static const MultistageLimits limits = multistageLimits(rk4Growth);
    return largestStableStep(limits, tissue, cap);
}

// A step takes x⁶/144 off a swing's logarithm where x = hω, ω·x⁵/144 per second; a viscosity takes ω²/2·d/c.
double rk4Damping(double timeStep, double frequency) {
    return timeStep * std::pow(timeStep * frequency, 4) / 72;
}

} // namespace

const Scheme rk4Scheme{.largestStable = largestRk4Step,
                       .ownDamping = rk4Damping,
                       .factors = massAlone,
                       .explicitMethod = {.stageRates = 4,
                                          .keptRates = 0,
                                          .stepInDouble = rk4Step<double>,
                                          .stepInFloat = rk4Step<float>,
                                          .growth = rk4Growth}};

} // namespace esm

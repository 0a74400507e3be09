#include "core/dynamics/schemes/schemes.h"

#include <cmath>

namespace esm {

namespace {

// (M + h·D)·v⁺ = M·v + h·(f(x) + g), x⁺ = x + h·v⁺: viscosity implicit, elasticity explicit. First order.
// Published organs are so viscous that D alone limits explicit steps; taken implicitly, it lengthens the
// stable step instead. Isotropic damping does not depend on places: its matrix is constant, and the solve is
// exact, nothing being linearised.
MatrixFactors splitFactors(double timeStep) {
    return {1, timeStep, 0};
}

// One oscillator's step, (1 + hd)·x⁺ − (2 + hd − h²k)·x + x⁻ = 0, reaches −1 where h²k − 2hd = 4. On the line
// d = ratio·k, the least damping there may be, that is h² − 2h·ratio < 4/k, hardest for the largest k: up to
// its root no motion grows.
//
// A fluid's stiffness s is taken implicitly, beside the viscosity: (1 + hd + h²s)·x⁺ …, which adds h²s to the
// right of both. It never shortens the step.
std::optional<double> largestSplitStep(TissueSpectrum& filled, double cap) {
    TissueSpectrum& tissue = filled.withoutFluids();
    if (tissue.largestStiffness() == 0) return cap;
    const double ratio = tissue.dampingRatio();
    const double sure = ratio + std::sqrt(ratio * ratio + 4 / tissue.largestStiffness());
    return tissue.largestDefinite({4, 2, -1}, sure, cap);
}

} // namespace

const Scheme splitScheme{.largestStable = largestSplitStep,
                         .ownDamping = dampsNothing,
                         .factors = splitFactors,
                         .form = eulerForm};

} // namespace esm

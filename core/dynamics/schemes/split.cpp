#include "core/dynamics/schemes/schemes.h"

#include <cmath>

namespace esm {

namespace {

// (M + h·D)·v⁺ = M·v + h·(f(x) + g), x⁺ = x + h·v⁺: viscosity implicit, elasticity explicit. First order. The
// matrix is constant, and viscous tissue, where D limits explicit steps, is stable in long ones.
MatrixFactors splitFactors(double timeStep) {
    return {1, timeStep, 0};
}

// λmax(h²K − 2hD) < 4; on the line d = ratio·k that is h² − 2h·ratio < 4/k.
std::optional<double> largestSplitStep(TissueSpectrum& tissue, double cap) {
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

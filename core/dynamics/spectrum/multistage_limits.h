#pragma once

#include "core/dynamics/spectrum/oscillator.h"
#include "core/dynamics/spectrum/tissue_spectrum.h"

#include <vector>

namespace esm {

/// What a Runge-Kutta or multistep integrator bears, whatever the tissue: worked out once for each of them.
struct MultistageLimits {
    double decay;                                     ///< decayLimit()
    std::vector<std::pair<double, double>> stiffness; ///< stiffnessLimit() at some dampings, increasing
};
MultistageLimits multistageLimits(Growth growth);

/// Largest stable step up to `cap`, s; empty where there is none. @throws Cancelled
std::optional<double> largestStableStep(const MultistageLimits& limits, TissueSpectrum& tissue, double cap);

} // namespace esm

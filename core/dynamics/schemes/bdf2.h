#pragma once

#include "core/dynamics/schemes/scheme.h"

namespace esm {

/// Backward differences over this step and the one before, of positions and velocities:
/// x⁺ = (4x − x⁻ + 2h·v⁺)/3, and M·(3v⁺ − 4v + v⁻)/2 = h·(forces at x⁺).
StepForm backwardDifferences(double timeStep, const Motion& before, const Motion& previous);

} // namespace esm

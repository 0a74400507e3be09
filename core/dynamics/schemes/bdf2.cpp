#include "core/dynamics/schemes/bdf2.h"

#include "core/dynamics/schemes/schemes.h"

#include <algorithm>

namespace esm {

namespace {

// (3/2·M + h·D + 2/3·h²·K)·v⁺ = M·(2v − v⁻/2) + h·(f(x) − K·(x − x⁻)/3 + g), x⁺ = (4x − x⁻ + 2h·v⁺)/3:
// backward differences over two steps, Newton steps as of implicit Euler. Second order. Stable at any step,
// and stiff motions die out.
MatrixFactors bdf2Factors(double timeStep) {
    return {1.5, timeStep, timeStep * timeStep * 2 / 3};
}

StepForm bdf2Form(double timeStep, const Motion& before, const Motion* previous) {
    StepForm form = backwardDifferences(timeStep, before, *previous);
    form.isExact = true;
    return form;
}

// ω·x³/4 per second off a swing's logarithm where x = hω, and no more than implicit Euler takes.
double bdf2Damping(double timeStep, double frequency) {
    const double x = timeStep * frequency;
    return timeStep * std::min(1.0, x * x / 2);
}

} // namespace

const Scheme bdf2Scheme{
    .largestStable = alwaysStable, .ownDamping = bdf2Damping, .factors = bdf2Factors, .form = bdf2Form};

// Both rows of the formula, for positions and for velocities, are 3y⁺ = 4y − y⁻ + 2h·ẏ⁺. That of the
// positions gives x⁺ − x = (x − x⁻)/3 + 2h/3·v⁺: the drift and the reach.
StepForm backwardDifferences(double timeStep, const Motion& before, const Motion& previous) {
    StepForm form{.drive = before.velocities, .drift = {}, .reach = 2 * timeStep / 3};
    form.drift.resize(before.positions.size());
    for (std::size_t i = 0; i < form.drift.size(); ++i) {
        form.drive[i] = 2 * before.velocities[i] - 0.5 * previous.velocities[i];
        form.drift[i] = (before.positions[i] - previous.positions[i]) / 3;
    }
    return form;
}

} // namespace esm

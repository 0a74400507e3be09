#include "core/dynamics/stability/swings.h"

#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/tissue_spectrum.h"
#include "core/dynamics/stability/stability.h"

#include <cmath>

namespace esm {

namespace {

constexpr double clearlyMore = 4;    ///< times; of two dampings the larger then decides how swings end
constexpr double hardlyAny = 0.25;   ///< of a swing's logarithm, in all of a run
constexpr double patience = 60;      ///< s, at the wall time that steps roughly take
constexpr double leastHalvings = 16; ///< of the longest stable step, four halvings, must still be affordable

SwingBounds boundsOf(const SpringSystem& system, Damping damping) {
    const TissueSpectrum tissue(system, damping, {1e-2, Deformation::Any, {}});
    return {tissue.largestAngularFrequency(), tissue.dampingRatio()};
}

} // namespace

double stepsPerSecond(const SpringSystem& system, Integrator integrator) {
    constexpr double other = 20; // springs, that a step's other work is worth
    const double springs = static_cast<double>(system.springs.size() + system.tethers.size()) + other;
    return 1 / (springs * traitsOf(integrator).stepCost);
}

SwingBounds swingBounds(const TissueModel& model, Damping damping) {
    return boundsOf(makeSpringSystem(model), damping);
}

// In a second, a viscosity of d/c takes ω²/2·d/c off the logarithm of a swing of ω. Steps that damp are like
// such a viscosity. They hide the fastest swing where they take a noticeable part of it. They do not where
// the tissue's own viscosity is clearly larger, which ends the swing anyhow.
bool hidesSwings(const SwingBounds& bounds, Integrator integrator, double timeStep, double duration) {
    const double ratio = schemeOf(integrator).ownDamping(timeStep, bounds.largestFrequency);
    const double taken = std::pow(bounds.largestFrequency, 2) / 2 * ratio * duration;
    return taken > hardlyAny && bounds.dampingRatio < clearlyMore * ratio;
}

std::optional<FollowingSteps> followingSteps(const TissueModel& model, Damping damping, double duration) {
    const SpringSystem system = makeSpringSystem(model);
    TissueSpectrum tissue(system, damping, {0.05, Deformation::Any, {}});
    std::vector<Integrator> candidates{Integrator::Verlet};
    if (damping == Damping::Isotropic)
        candidates = {Integrator::Split2, Integrator::Verlet, Integrator::Split};
    for (const Integrator integrator : candidates) {
        const double longest = schemeOf(integrator).largestStable(tissue, longestStep).value_or(0);
        const double most = patience * stepsPerSecond(system, integrator);
        if (longest >= shortestStep && leastHalvings * duration / longest <= most)
            return FollowingSteps{integrator, most};
    }
    return std::nullopt;
}

} // namespace esm

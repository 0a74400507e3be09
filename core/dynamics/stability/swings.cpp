#include "core/dynamics/stability/swings.h"

#include "core/dynamics/stability/stability_rules.h"

#include <cmath>

namespace esm {

namespace {

constexpr double clearlyMore = 4;    ///< times; of two dampings the larger then decides how swings end
constexpr double hardlyAny = 0.25;   ///< of a swing's logarithm, in all of a run
constexpr double patience = 60;      ///< s, at the wall time that steps roughly take
constexpr double leastHalvings = 16; ///< times as many steps as the longest stable ones are to be affordable

SwingBounds boundsOf(const SpringSystem& system, Damping damping) {
    const StabilityRules rules(system, damping, {1e-2, Deformation::Any, {}});
    // Across its axis a spring that damps along it alone has elasticity but no damping.
    const double ratio = damping == Damping::Isotropic ? leastDampingRatio(system) : 0;
    return {rules.largestAngularFrequency(), ratio};
}

/// s, d/c of a viscosity that damps the fastest swings as much as the steps do by themselves. Of frequency ω
/// and with x = hω, implicit Euler takes ω·x/2 per second off a swing's logarithm, backward differences
/// ω·x³/4 and no more than that, Runge-Kutta ω·x⁵/144; a viscosity takes ω²/2·d/c.
double dampingRatioOfSteps(Integrator integrator, double timeStep, double frequency) {
    const double x = timeStep * frequency;
    switch (integrator) {
    case Integrator::Implicit:
    case Integrator::Projective:
    case Integrator::Propagation:
        return timeStep;
    case Integrator::Bdf2:
        return timeStep * std::min(1.0, x * x / 2);
    case Integrator::Rk4:
        return timeStep * std::pow(x, 4) / 72;
    default:
        return 0;
    }
}

} // namespace

double stepsPerSecond(const SpringSystem& system, Integrator integrator) {
    constexpr double explicitSeconds = 5e-9, solvingSeconds = 5e-8; // per node or spring
    constexpr double least = 20;                                    // of them; a step has more to do
    const double things = static_cast<double>(system.mass.size() + system.springs.size()) + least;
    return 1 / (things * (isExplicit(integrator) ? explicitSeconds : solvingSeconds));
}

SwingBounds swingBounds(const TissueModel& model, Damping damping) {
    return boundsOf(makeSpringSystem(model), damping);
}

bool hidesSwings(const SwingBounds& bounds, Integrator integrator, double timeStep, double duration) {
    const double ratio = dampingRatioOfSteps(integrator, timeStep, bounds.largestFrequency);
    const double taken = std::pow(bounds.largestFrequency, 2) / 2 * ratio * duration;
    return taken > hardlyAny && bounds.dampingRatio < clearlyMore * ratio;
}

bool lagsWhereTissueTurns(Integrator integrator) {
    return integrator == Integrator::Projective;
}

std::optional<FollowingSteps> followingSteps(const TissueModel& model, Damping damping, double duration) {
    const SpringSystem system = makeSpringSystem(model);
    StabilityRules rules(system, damping, {0.05, Deformation::Any, {}});
    std::vector<Integrator> candidates{Integrator::Verlet};
    if (damping == Damping::Isotropic)
        candidates = {Integrator::Split2, Integrator::Verlet, Integrator::Split};
    for (const Integrator integrator : candidates) {
        const double longest = rules.largestStable(integrator, longestStep).value_or(0);
        const double most = patience * stepsPerSecond(system, integrator);
        if (longest >= shortestStep && leastHalvings * duration / longest <= most)
            return FollowingSteps{integrator, most};
    }
    return std::nullopt;
}

} // namespace esm

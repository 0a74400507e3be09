#include "core/dynamics/stability/stability.h"

#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/tissue_spectrum.h"
#include "core/support/errors.h"

#include <cmath>
#include <sstream>

namespace esm {

namespace {

constexpr double safetyFactor = 0.9;

/// Only explicit integrators compute in float or leave out what rests.
bool hasToBeExplicit(const SimulationSettings& settings) {
    return settings.precision == Precision::Float || settings.restTolerance > 0;
}

// Largest step up to `cap`, s, at which `implicit` and `bdf2` are sure to solve for the velocities.
//
// Preconditioned with the Laplacian's matrix, M + h·D + h²·K has its eigenvalues between 1 and 1/c, where K
// may vanish for a motion that the Laplacian resists with k: c = 1 + h²·k/(1 + h·d), most at the largest k,
// where d is at least ratio·k. The error of conjugate gradients falls as 2·exp(−2n/√c) or faster with n
// iterations, to 10⁻¹⁰ in some 12·√c of them: 850 for c = 5000, below the 1000 that the solver is given.
double largestSolvable(TissueSpectrum& filled, double cap) {
    const TissueSpectrum& tissue = filled.withoutFluids();
    constexpr double mostContrast = 5000;
    if (tissue.largestStiffness() == 0) return cap;
    const double damped = 0.5 * mostContrast * tissue.dampingRatio();
    return std::min(cap, damped + std::sqrt(damped * damped + mostContrast / tissue.largestStiffness()));
}

/// Where a given step is too long for all that take elasticity explicitly, it has to be taken implicitly.
Integrator integratorFor(TissueSpectrum& tissue, const SimulationSettings& settings, double step) {
    if (hasToBeExplicit(settings)) return Integrator::Euler;
    std::vector<Integrator> candidates{Integrator::Euler};
    if (settings.damping == Damping::Isotropic)
        candidates = {Integrator::Split2, Integrator::Split, Integrator::Euler};
    for (const Integrator integrator : candidates)
        if (schemeOf(integrator).largestStable(tissue, step).value_or(0) >= step) return integrator;
    return Integrator::Bdf2;
}

/// s per spring: roughly the wall time that a simulated second takes. Rough figures are enough: they only
/// decide whether a choice falls behind real time, and which of two does so less.
double costOf(const ChosenStep& chosen) {
    return traitsOf(chosen.integrator).stepCost / chosen.timeStep;
}

/// The second-order form is worth a shorter step than the first-order one, but not any; where viscosity is so
/// small that taking it implicitly gains nothing, the explicit step is as good and cheaper. Where all of them
/// fall behind real time, elasticity has to be taken implicitly as well.
ChosenStep bestChoice(TissueSpectrum& tissue, const SimulationSettings& settings, double cap,
                      std::size_t springs) {
    const auto longest = [&](Integrator integrator) {
        return ChosenStep{integrator, schemeOf(integrator).largestStable(tissue, cap).value_or(0)};
    };
    const auto inTime = [&](const ChosenStep& chosen) {
        if (costOf(chosen) * static_cast<double>(springs) <= 1) return chosen;
        // As long as conjugate gradients are sure to solve for it.
        const ChosenStep implicit{Integrator::Bdf2, largestSolvable(tissue, cap)};
        // An organ so large that no step keeps up is not made faster by one that costs more.
        const bool isTooShort = chosen.timeStep * safetyFactor < shortestStep;
        return isTooShort || costOf(implicit) < costOf(chosen) ? implicit : chosen;
    };
    if (hasToBeExplicit(settings)) return longest(Integrator::Euler);
    if (settings.damping == Damping::Axial) return inTime(longest(Integrator::Euler));
    const ChosenStep split = longest(Integrator::Split);
    ChosenStep split2 = longest(Integrator::Split2);
    // Steps after a jump are first-order ones.
    split2.timeStep = std::min(split.timeStep, split2.timeStep);
    if (split2.timeStep >= 0.5 * split.timeStep) return inTime(split2);
    const ChosenStep euler = longest(Integrator::Euler);
    return inTime(euler.timeStep >= 0.8 * split.timeStep ? euler : split);
}

[[noreturn]] void refuse(Integrator integrator, double step) {
    std::ostringstream message;
    message << "the longest stable step of " << integratorName(integrator) << " would be " << step
            << " s, too short to compute with: lower the spring constant or the viscosity, or raise the mass";
    throw InvalidModel(message.str());
}

[[noreturn]] void refuseUndamped(const SimulationSettings& settings) {
    const std::string name = integratorName(settings.integrator);
    if (settings.damping == Damping::Axial)
        throw InvalidModel(
            name + " has no stable step with axial damping, by which tissue swings undamped across its "
                   "springs: choose another integrator or auto, or isotropic damping");
    throw InvalidModel(name + " has no stable step where a spring or tether has no viscosity: choose another "
                              "integrator or auto, or give all of the tissue some viscosity");
}

/// Where nothing has to be chosen. @throws InvalidModel for settings with problems
std::optional<ChosenStep> givenStep(const SimulationSettings& settings) {
    if (auto problems = validate(settings); !problems.empty()) throw InvalidModel(std::move(problems));
    if (!settings.timeStep || settings.integrator == Integrator::Auto) return std::nullopt;
    return ChosenStep{settings.integrator, *settings.timeStep};
}

} // namespace

std::optional<double> criticalStep(const TissueModel& model, Integrator integrator,
                                   const StabilitySearch& search, Damping damping) {
    TissueSpectrum tissue(makeSpringSystem(model), damping, search);
    return schemeOf(integrator).largestStable(tissue, noStepLimit);
}

CriticalSteps criticalSteps(const TissueModel& model, Damping damping, const StabilitySearch& search) {
    TissueSpectrum tissue(makeSpringSystem(model), damping, search);
    CriticalSteps steps;
    for (const Integrator integrator : allIntegrators)
        if (damping == Damping::Isotropic || traitsOf(integrator).mayDampAxially)
            steps[integrator] = schemeOf(integrator).largestStable(tissue, noStepLimit);
    return steps;
}

bool isStable(const TissueModel& model, const Stepping& stepping) {
    constexpr double tolerance = 0.01; // less than the margin of any step that is chosen
    TissueSpectrum tissue(makeSpringSystem(model), Damping::Isotropic, {tolerance, Deformation::Any, {}});
    const double step = stepping.timeStep;
    return schemeOf(stepping.integrator).largestStable(tissue, step).value_or(0) >= step * (1 - 1e-9);
}

SimulationSettings steppedAsRecommended(const SimulationSettings& settings, const TissueModel& model,
                                        const std::optional<MeasuredStepping>& recommended) {
    const bool isOfThisKind = settings.damping == Damping::Isotropic && settings.restTolerance == 0;
    if (!recommended || !isOfThisKind || !isStable(model, recommended->stepping)) return settings;
    return withStepping(settings, recommended->stepping);
}

double largestAngularFrequency(const TissueModel& model) {
    return TissueSpectrum(makeSpringSystem(model), Damping::Isotropic, {1e-3, Deformation::AtRest, {}})
        .largestAngularFrequency();
}

ChosenStep chooseStep(const TissueModel& model, const SimulationSettings& settings) {
    if (const auto given = givenStep(settings)) return *given;
    return chooseStep(makeSpringSystem(model), settings);
}

ChosenStep chooseStep(const SpringSystem& system, const SimulationSettings& settings) {
    if (const auto given = givenStep(settings)) return *given;
    const bool isAuto = settings.integrator == Integrator::Auto;
    TissueSpectrum tissue(system, settings.damping, {0.05, Deformation::Any, {}});
    if (settings.timeStep) return {integratorFor(tissue, settings, *settings.timeStep), *settings.timeStep};

    const double cap = longestStep / safetyFactor;
    ChosenStep chosen{settings.integrator, 0};
    if (isAuto)
        chosen = bestChoice(tissue, settings, cap, system.springs.size());
    else if (const auto step = schemeOf(settings.integrator).largestStable(tissue, cap))
        chosen.timeStep = *step;
    else
        refuseUndamped(settings);
    chosen.timeStep = std::min(longestStep, chosen.timeStep * safetyFactor);
    if (chosen.timeStep < shortestStep) refuse(chosen.integrator, chosen.timeStep);
    return chosen;
}

} // namespace esm

#include "core/dynamics/schemes/split2.h"

#include "core/dynamics/schemes/bdf2.h"
#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/largest_holding.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

// (3/2·M + h·D)·v⁺ = M·(2v − v⁻/2) + h·(2f − f⁻ + g), x⁺ = (4x − x⁻ + 2h·v⁺)/3: backward differences with the
// viscosity implicit and the elasticity extrapolated from two steps. Second order, a constant matrix. The
// extrapolation lets undamped swings grow: all of the tissue needs some viscosity.
//
// It is one of the implicit-explicit multistep forms of Ascher, Ruuth and Wetton (1995).
MatrixFactors split2Factors(double timeStep) {
    return {1.5, timeStep, 0};
}

StepForm split2Form(double timeStep, const Motion& before, const Motion* previous) {
    StepForm form = backwardDifferences(timeStep, before, *previous);
    form.extrapolates = true;
    return form;
}

/// The least of split2Limit(x)/x up to x = 8/7.
const double leastQuotient = 2.5 + std::sqrt(6.0);

// On the line d = ratio·k up to the largest k: h/ratio must stay below split2Limit(x)/x for every x ≤
// h·ratio·k. That quotient falls to 5/2 + √6 at x = 0.3866, rises a little and falls again, not below that
// before x = 8/7.
//
// The search starts from a step that holds: h = 4/3·ratio, at which h²k is 4/3·hd for every motion and so
// below both branches. With little damping a longer one does, where (hω)² is √(2·hd) at the largest k; that
// is tried.
double split2OnLine(const TissueSpectrum& tissue, double cap) {
    const double ratio = tissue.dampingRatio(), stiffest = tissue.largestStiffness();
    const auto holds = [ratio, stiffest](double h) {
        const double damping = h * ratio * stiffest;
        const double quotient = split2Limit(damping) / damping;
        return h / ratio < (damping < 0.3866 ? quotient : std::min(quotient, leastQuotient));
    };
    const double strong = 4.0 / 3 * ratio, weak = std::cbrt(2 * ratio / stiffest);
    return largestHolding(holds(weak) ? std::max(weak, strong) : strong, cap, 1e-3, holds);
}

// There are two kinds of motion. Those with h·d ≥ 8/7 leave the unit circle at −1: there the rule is a half
// plane of (k, d), and so a matrix that has to be definite. The others are stable up to h =
// leastQuotient·ratio, all of them; and where all of the tissue is damped beyond 8/7, there are none.
std::optional<double> largestSplit2Step(TissueSpectrum& filled, double cap) {
    TissueSpectrum& tissue = filled.withoutFluids();
    if (tissue.largestStiffness() == 0) return cap;
    if (tissue.dampingRatio() == 0) return std::nullopt;
    const double sure = split2OnLine(tissue, cap);
    const double forAll = std::max(sure, leastQuotient * tissue.dampingRatio());
    const double halfPlane = tissue.largestDefinite({16.0 / 3, 4.0 / 3, -1}, sure, cap);
    if (halfPlane <= forAll || tissue.isDampedBeyond(8.0 / 7, sure)) return halfPlane;
    return forAll;
}

} // namespace

const Scheme split2Scheme{.largestStable = largestSplit2Step,
                          .ownDamping = dampsNothing,
                          .factors = split2Factors,
                          .form = split2Form};

double split2Limit(double stepDamping) {
    if (stepDamping >= 8.0 / 7) return 16.0 / 3 + 4.0 / 3 * stepDamping;
    // Roots e^{iθ}, u = 1 − cos θ: stepDamping = 2u²/(1+3u), limit = stepDamping·(1/u + 5/2 + 3u/2).
    const double u = (3 * stepDamping + std::sqrt(9 * stepDamping * stepDamping + 8 * stepDamping)) / 4;
    return u > 0 ? stepDamping * (1 / u + 2.5 + 1.5 * u) : 0;
}

} // namespace esm

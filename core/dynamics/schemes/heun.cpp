#include "core/dynamics/schemes/explicit_work.h"
#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/multistage_limits.h"

#include <cmath>

namespace esm {

namespace {

// Heun's form [B 4.2], the explicit trapezoidal rule: ṽ = v + h·a(x,v), x̃ = x + h·v; v⁺ = v + h/2·(a(x,v) +
// a(x̃,ṽ)), x⁺ = x + h/2·(v + ṽ). Second order, two evaluations. An undamped swing grows, however short the
// steps: by √(1 + x⁴/4) in each, x = hω.
template<class Real> void heunStep(ExplicitWork<Real>& work, const StepInput& input) {
    const double h = input.duration;
    auto &first = work.stageRates[0], &second = work.stageRates[1];
    work.computeRates(input, 0, work.state, first);
    work.computeRates(input, 1, work.stage({{h, &first}}), second);
    work.finish({{h / 2, &first}, {h / 2, &second}});
}

// The series of e^z as far as the second order: what every explicit form of two evaluations and second order
// makes of y' = z·y.
double heunGrowth(std::complex<double> z) {
    return std::abs(1.0 + z + z * z / 2.0);
}

std::optional<double> largestHeunStep(TissueSpectrum& tissue, double cap) {
    static const MultistageLimits limits = multistageLimits(heunGrowth);
    return largestStableStep(limits, tissue, cap);
}

} // namespace

const Scheme heunScheme{.largestStable = largestHeunStep,
                        .ownDamping = dampsNothing,
                        .factors = massAlone,
                        .explicitMethod = {.stageRates = 2,
                                           .keptRates = 0,
                                           .stepInDouble = heunStep<double>,
                                           .stepInFloat = heunStep<float>,
                                           .growth = heunGrowth}};

} // namespace esm

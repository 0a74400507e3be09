#pragma once

#include "core/dynamics/schemes/explicit_work.h"

namespace esm {

/// A step of the classical Runge-Kutta form, given its first evaluation. Precondition: `first` are the rates
/// of the state, and there are four to keep within a step; the first of these may be `first`.
template<class Real>
void rungeKuttaStep(ExplicitWork<Real>& work, const StepInput& input,
                    const typename ExplicitWork<Real>::State& first) {
    const double h = input.duration;
    auto &second = work.stageRates[1], &third = work.stageRates[2], &fourth = work.stageRates[3];
    work.computeRates(input, 0.5, work.stage({{h / 2, &first}}), second);
    work.computeRates(input, 0.5, work.stage({{h / 2, &second}}), third);
    work.computeRates(input, 1, work.stage({{h, &third}}), fourth);
    work.finish({{h / 6, &first}, {h / 3, &second}, {h / 3, &third}, {h / 6, &fourth}});
}

} // namespace esm

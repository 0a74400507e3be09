#include "core/dynamics/schemes/explicit_work.h"
#include "core/dynamics/schemes/rk4.h"
#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spectrum/multistage_limits.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace esm {

namespace {

// Adams-Bashforth predicts, Adams-Moulton corrects [B 4.2]. With y = (x,v) and F = (v,a): ỹ = y + h/24·(55F −
// 59F⁻ + 37F⁻² − 9F⁻³), y⁺ = y + h/24·(9F̃ + 19F − 5F⁻ + F⁻²). Fourth order for two evaluations, half of what
// Runge-Kutta's form takes, since three are left over from the steps before. For the same reason it has to
// begin anew after a jump: it starts with Runge-Kutta's steps, until three lie behind it. The next step
// evaluates F at y⁺ anew; to go on with F̃ would save that, but shorten the stable step.
template<class Real> void adamsMoultonStep(ExplicitWork<Real>& work, const StepInput& input) {
    std::rotate(work.keptRates.begin(), work.keptRates.end() - 1, work.keptRates.end());
    work.computeRates(input, 0, work.state, work.keptRates[0]);
    work.ratesKnown = std::min(work.ratesKnown + 1, work.keptRates.size());
    if (work.ratesKnown < work.keptRates.size()) return rungeKuttaStep(work, input, work.keptRates[0]);
    const double part = input.duration / 24;
    const auto &now = work.keptRates[0], &last = work.keptRates[1], &second = work.keptRates[2],
               &third = work.keptRates[3];
    auto& predicted = work.stageRates[0];
    work.computeRates(
        input, 1,
        work.stage({{55 * part, &now}, {-59 * part, &last}, {37 * part, &second}, {-9 * part, &third}}),
        predicted);
    work.finish({{9 * part, &predicted}, {19 * part, &now}, {-5 * part, &last}, {part, &second}});
}

// With F = z·y in both formulas, y⁺ is a sum over the last four y: the first row of the companion matrix. Its
// largest eigenvalue is the largest root of that recurrence.
double adamsMoultonGrowth(std::complex<double> z) {
    const std::complex<double> part = z / 24.0;
    Eigen::Matrix4cd recurrence = Eigen::Matrix4cd::Zero();
    recurrence.row(0) << 1.0 + part * (28.0 + 495.0 * part), part * (-5.0 - 531.0 * part),
        part * (1.0 + 333.0 * part), -81.0 * part * part;
    recurrence.bottomLeftCorner<3, 3>().setIdentity();
    return Eigen::ComplexEigenSolver<Eigen::Matrix4cd>(recurrence, false).eigenvalues().cwiseAbs().maxCoeff();
}

std::optional<double> largestAdamsMoultonStep(TissueSpectrum& tissue, double cap) {
    static const MultistageLimits limits = multistageLimits(adamsMoultonGrowth);
    return largestStableStep(limits, tissue, cap);
}

} // namespace

const Scheme adamsMoultonScheme{.largestStable = largestAdamsMoultonStep,
                                .ownDamping = dampsNothing,
                                .factors = massAlone,
                                .explicitMethod = {.stageRates = 4,
                                                   .keptRates = 4,
                                                   .stepInDouble = adamsMoultonStep<double>,
                                                   .stepInFloat = adamsMoultonStep<float>,
                                                   .growth = adamsMoultonGrowth}};

} // namespace esm

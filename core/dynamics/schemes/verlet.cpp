#include "core/dynamics/schemes/explicit_work.h"
#include "core/dynamics/schemes/schemes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {

namespace {

// Velocity Verlet (Swope et al. 1982): x⁺ = x + h·v + h²/2·a, a⁺ = a(x⁺, v + h·a), v⁺ = v + h/2·(a + a⁺).
// Second order, and one evaluation as in Euler's step, since a⁺ is the next step's a. It was asked for at the
// predicted velocity: to ask again at v⁺ would cost a second evaluation in every step.
template<class Real> void verletStep(ExplicitWork<Real>& work, const StepInput& input) {
    const double h = input.duration;
    auto &last = work.keptRates[0], &now = work.keptRates[1];
    if (work.ratesKnown == 0) work.computeRates(input, 0, work.state, last);
    // Both halves of the state moved by h·(v, a): the velocity is then the one that forces are asked at, and
    // the position lacks h²/2·a.
    work.advance(work.between, {{h, &last}});
    const auto whole = static_cast<Real>(h), half = static_cast<Real>(h * h / 2);
    work.forActiveRows([&](std::size_t row) {
        for (int axis = 0; axis < 3; ++axis) {
            work.between[row].position[axis] = work.state[row].position[axis];
            work.addKeeping(whole * last[row].position[axis] + half * last[row].velocity[axis], row, axis,
                            work.between[row].position[axis]);
        }
    });
    work.computeRates(input, 1, work.between, now);
    work.advance(work.next, {{h / 2, &last}, {h / 2, &now}});
    work.forActiveRows([&](std::size_t row) {
        std::copy_n(work.between[row].position, 4, work.next[row].position);
        // The next step starts from this step's velocity, not from the predicted one.
        std::copy_n(work.next[row].velocity, 4, now[row].position);
    });
    std::swap(last, now);
    work.ratesKnown = 1;
}

// In terms of the velocities in the middle of steps, w = v + h/2·a, it is w⁺ = w − h·(K·x⁺ + D·(3w − w⁻)/2):
// leapfrog, its damping extrapolated from two steps. That reaches −1 first, where h²k + 4hd = 4.
// Extrapolating costs viscous tissue half of the step that Euler's has.
std::optional<double> largestVerletStep(TissueSpectrum& tissue, double cap) {
    const double d = tissue.largestDamping();
    const double sure = 2 / (d + std::sqrt(d * d + tissue.largestStiffness()));
    return tissue.largestDefinite({4, -4, -1}, sure, cap);
}

} // namespace

const Scheme verletScheme{
    .largestStable = largestVerletStep,
    .ownDamping = dampsNothing,
    .factors = massAlone,
    .explicitMethod = {.keptRates = 2, .stepInDouble = verletStep<double>, .stepInFloat = verletStep<float>}};

} // namespace esm

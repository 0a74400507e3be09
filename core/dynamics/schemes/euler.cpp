#include "core/dynamics/schemes/explicit_work.h"
#include "core/dynamics/schemes/schemes.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

// Semi-implicit Euler [B 4.7]: v⁺ = v + h·a(x,v), x⁺ = x + h·v⁺, with a = M⁻¹·(f(x) − D·v + g). First order,
// one evaluation, all of it in the kernel; forces on single nodes and those of fluids are added after it. It
// keeps the energy of a swing, seen in the middle of a step, for ever, which plain explicit Euler does not.
template<class Real> void eulerStep(ExplicitWork<Real>& work, const StepInput& input) {
    const double h = input.duration;
    const Loads& loads = *input.loads;
    const typename TissueKernel<Real>::Step step{h, loads.gravity,
                                                 keepsRemainders<Real> ? &work.remainders : nullptr};
    if (work.active.areAll())
        work.kernel.step(work.state, work.next, step);
    else
        work.kernel.step(work.state, work.next, step, work.active.list());
    work.forOuterForces(loads, 0.5, work.state,
                        [&](std::size_t row, double inverseMass, const Eigen::Vector3d& force) {
                            const Eigen::Vector3d change = h * inverseMass * force;
                            addToComponents(work.next[row].velocity, change);
                            for (int axis = 0; axis < 3; ++axis)
                                work.addKeeping(static_cast<Real>(h * change[axis]), row, axis,
                                                work.next[row].position[axis]);
                        });
    for (const PrescribedNode& led : input.prescribed) {
        const std::size_t row = work.kernel.rowOf(led.node);
        setComponents(work.next[row].position, led.position);
        std::copy_n(work.state[row].velocity, 4, work.next[row].velocity);
    }
}

// The step of one oscillator, x⁺ − 2x + x⁻ + h²k·x + hd·(x − x⁻) = 0, has its roots' product at 1 − hd and
// reaches −1 first, where h²k + 2hd = 4. What is sure, before any search, is that bound with the largest k
// and the largest d together, though no motion need have both.
std::optional<double> largestEulerStep(TissueSpectrum& tissue, double cap) {
    const double d = tissue.largestDamping();
    const double sure = 4 / (d + std::sqrt(d * d + 4 * tissue.largestStiffness()));
    return tissue.largestDefinite({4, -2, -1}, sure, cap);
}

} // namespace

const Scheme eulerScheme{
    .largestStable = largestEulerStep,
    .ownDamping = dampsNothing,
    .factors = massAlone,
    .explicitMethod = {.stepInDouble = eulerStep<double>, .stepInFloat = eulerStep<float>}};

} // namespace esm

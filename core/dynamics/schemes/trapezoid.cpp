#include "core/dynamics/schemes/schemes.h"

namespace esm {

namespace {

// The implicit trapezoidal rule: v⁺ = v + h/2·(a(x,v) + a(x⁺,v⁺)), x⁺ = x + h/2·(v + v⁺). Solved for the mean
// velocity w = (v + v⁺)/2, in which it is M·(2w − 2v) = h·(½·f(x) + ½·f(x + h·w) − D·w + g): what is led goes
// evenly at w through the step, where v⁺ = 2w − v would ring for ever after any change of its speed. One
// Newton step with the whole tangent; where its potential says that it overshoots, a step of implicit Euler
// in its place.
//
// That no step is too long holds for linear springs. Where springs turn or stiffen in long steps, the
// tangent's error makes energy that nothing takes away: of the 94 cases of `esmc extremes` 24 ran wild. A
// step that gains energy so is one of implicit Euler, too.
//
// Second order. A linear oscillator grows by |(1 + z/2)/(1 − z/2)|: never, at any step, and not at all where
// nothing damps, so that swings go on for ever. As z → −∞ that is 1 too: what is stiff would ring after a
// jump of the loads, though true motion has ended it. Each jump is therefore followed by one step of implicit
// Euler, which takes stiff motion down by 1/(1 − z); a single step of the first order leaves the second
// [Rannacher 1984]. Springs that damp along their axes alone would need their directions at both ends:
// refused.
StepForm trapezoidForm(double timeStep, const Motion& before, const Motion* /*previous*/) {
    StepForm form{.drive = before.velocities, .drift = {}, .reach = timeStep};
    for (Eigen::Vector3d& velocity : form.drive)
        velocity *= 2;
    form.endShare = 0.5;
    form.beyond = 1;
    form.isExact = true;
    form.keepsEnergy = true;
    return form;
}

MatrixFactors trapezoidFactors(double timeStep) {
    return {2, timeStep, timeStep * timeStep / 2};
}

// Its own steps damp nothing. The first after a jump takes ½·ln(1 + x²) off a swing's logarithm, x = hω, and
// none brings it back: from x = 0.8 on that is a quarter, and the swing counts as damped as by implicit
// Euler.
double trapezoidDamping(double timeStep, double frequency) {
    constexpr double lastFollowed = 0.8;
    return timeStep * frequency < lastFollowed ? 0 : timeStep;
}

} // namespace

const Scheme trapezoidScheme{.largestStable = alwaysStable,
                             .ownDamping = trapezoidDamping,
                             .factors = trapezoidFactors,
                             .form = trapezoidForm};

} // namespace esm

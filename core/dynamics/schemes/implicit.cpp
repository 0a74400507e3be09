#include "core/dynamics/schemes/schemes.h"

namespace esm {

// Implicit Euler, (M + h·D + h²·K)·v⁺ = M·v + h·(f(x) + g), x⁺ = x + h·v⁺: one Newton step (Baraff and Witkin
// 1998), where in K, the tangent of −f, springs do not buckle. What further Newton steps would change is of
// no lower order in h than the step's own error. With axial damping up to four of them, towards f and D at
// x⁺. First order, stable at any step, and takes every swing away that is faster than its steps: by 1/√(1 +
// x²) in each, x = hω.
const Scheme implicitScheme{.largestStable = alwaysStable,
                            .ownDamping = dampsAsImplicitEuler,
                            .factors = implicitEulerFactors,
                            .form = eulerForm};

StepForm eulerForm(double timeStep, const Motion& before, const Motion* /*previous*/) {
    return {.drive = before.velocities, .drift = {}, .reach = timeStep};
}

} // namespace esm

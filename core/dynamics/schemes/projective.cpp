#include "core/dynamics/schemes/schemes.h"

namespace esm {

// As implicit Euler with the weighted graph Laplacian in place of K: a constant matrix, one iteration of
// projective dynamics (for springs Liu et al. 2013, in general Bouaziz et al. 2014). First order. What it
// gains is that one factorisation does for all steps. What it costs: the Laplacian resists the turning of
// springs as it resists their stretching, so that tissue which turns lags behind, and more iterations, each
// as dear as a step, would only slowly catch up. A spring that is beyond its strain before or after the step
// counts with the larger of its constants: with the smaller one the matrix would no longer be above the
// tangent, and a step could overshoot.
const Scheme projectiveScheme{.largestStable = alwaysStable,
                              .ownDamping = dampsAsImplicitEuler,
                              .factors = implicitEulerFactors,
                              .form = eulerForm};

} // namespace esm

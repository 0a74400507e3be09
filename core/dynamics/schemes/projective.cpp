#include "core/dynamics/schemes/schemes.h"

namespace esm {

// As implicit Euler with the weighted graph Laplacian in place of K: a constant matrix, one iteration of
// projective dynamics. First order. The Laplacian resists the turning of springs as it resists their
// stretching. A spring that is beyond its strain before or after the step counts with the larger of its
// constants.
const Scheme projectiveScheme{.largestStable = alwaysStable,
                              .ownDamping = dampsAsImplicitEuler,
                              .factors = implicitEulerFactors,
                              .form = eulerForm};

} // namespace esm

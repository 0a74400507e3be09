#pragma once

#include "core/dynamics/spectrum/symmetric_sum.h"

namespace esm {

/// An upper estimate of an eigenvalue and what is nearly its vector, of length 1; empty for a matrix without
/// rows or entries.
struct Eigenpair {
    double value;
    Eigen::VectorXd vector;
};

/// Of a symmetric, positive semidefinite matrix, an upper estimate of the
/// largest eigenvalue within about twice the tolerance, relative: Lanczos with its residual added, and never
/// above Gershgorin's bound.
double largestEigenvalue(const SymmetricSum& matrix, double tolerance = 5e-4);
/// The same with the vector, in twice the time.
Eigenpair largestEigenpair(const SymmetricSum& matrix, double tolerance);

} // namespace esm

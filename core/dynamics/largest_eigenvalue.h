#pragma once

#include <Eigen/SparseCore>

namespace esm {

/// An upper estimate of the largest eigenvalue of a symmetric, positive semidefinite matrix of which the
/// lower half is stored, within about a thousandth: Lanczos with its residual added, and never above
/// Gershgorin's bound.
double largestEigenvalue(const Eigen::SparseMatrix<double>& lower);

} // namespace esm

#pragma once

#include <Eigen/SparseCore>

namespace esm {

/// An upper estimate of the largest eigenvalue of a symmetric, positive semidefinite matrix of which the
/// lower half is stored, within about a thousandth: Lanczos with its residual added, and never above
/// Gershgorin's bound.
double largestEigenvalue(const Eigen::SparseMatrix<double>& lower);

/// The same within a relative tolerance, in few iterations from what is nearly the eigenvector, as that of a
/// matrix much like this one; any vector of another size is as good as none. It becomes the eigenvector.
/// Where another eigenvector has overtaken, the estimate may be too low.
double largestEigenvalueNear(Eigen::VectorXd& eigenvector, const Eigen::SparseMatrix<double>& lower,
                             double tolerance);

} // namespace esm

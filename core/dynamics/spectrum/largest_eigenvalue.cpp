#include "core/dynamics/spectrum/largest_eigenvalue.h"

#include "core/dynamics/spectrum/lanczos.h"

namespace esm {

namespace {

// No eigenvalue is larger than the largest sum of a row's absolute values. That costs one pass and is never
// too low, but too high: for the graph Laplacian of an even triangle mesh 12 in place of 9. Lanczos' value
// comes close, but from below; with its residual added it is above an eigenvalue, and rarely not the largest.
double gershgorinBound(const Eigen::SparseMatrix<double>& lower) {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.rows());
    for (int column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
            sums[it.row()] += std::abs(it.value());
            if (it.row() != column) sums[column] += std::abs(it.value());
        }
    return lower.rows() > 0 ? sums.maxCoeff() : 0;
}

RitzPair estimate(const Eigen::SparseMatrix<double>& lower, double tolerance) {
    const auto isEnough = [tolerance](const RitzPair& pair) {
        return pair.residual < tolerance * pair.value;
    };
    return largestRitzPair(lower, arbitraryDirection(lower.rows()), {isEnough, 8, 120});
}

} // namespace

double largestEigenvalue(const Eigen::SparseMatrix<double>& lower, double tolerance) {
    const double bound = gershgorinBound(lower);
    if (!(bound > 0)) return 0;
    const RitzPair pair = estimate(lower, tolerance);
    return std::min(bound, pair.value + pair.residual);
}

Eigenpair largestEigenpair(const Eigen::SparseMatrix<double>& lower, double tolerance) {
    const double bound = gershgorinBound(lower);
    if (!(bound > 0)) return {0, {}};
    const RitzPair pair = estimate(lower, tolerance);
    return {std::min(bound, pair.value + pair.residual),
            ritzVector(pair, lower, arbitraryDirection(lower.rows()))};
}

} // namespace esm

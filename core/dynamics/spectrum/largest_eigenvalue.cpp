#include "core/dynamics/spectrum/largest_eigenvalue.h"

#include "core/dynamics/spectrum/lanczos.h"

namespace esm {

namespace {

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

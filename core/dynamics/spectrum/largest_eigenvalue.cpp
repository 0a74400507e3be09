#include "core/dynamics/spectrum/largest_eigenvalue.h"

#include "core/dynamics/spectrum/lanczos.h"

namespace esm {

namespace {

// No eigenvalue is larger than the largest sum of a row's absolute values, and what is added of low rank adds
// its trace at most. That costs one pass and is never too low, but too high: for the graph Laplacian of an
// even triangle mesh 12 in place of 9. Lanczos' value comes close, but from below; with its residual added it
// is above an eigenvalue, and rarely not the largest.
double gershgorinBound(const SymmetricSum& matrix) {
    const Eigen::SparseMatrix<double>& lower = matrix.lower;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.rows());
    for (int column = 0; column < lower.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(lower, column); it; ++it) {
            sums[it.row()] += std::abs(it.value());
            if (it.row() != column) sums[column] += std::abs(it.value());
        }
    const double bound = lower.rows() > 0 ? sums.maxCoeff() : 0;
    return matrix.columns.cols() > 0 ? bound + matrix.factor * matrix.columns.squaredNorm() : bound;
}

RitzPair estimate(const SymmetricSum& matrix, double tolerance) {
    const auto isEnough = [tolerance](const RitzPair& pair) {
        return pair.residual < tolerance * pair.value;
    };
    return largestRitzPair(matrix, arbitraryDirection(matrix.rows()), {isEnough, 8, 120});
}

} // namespace

double largestEigenvalue(const SymmetricSum& matrix, double tolerance) {
    const double bound = gershgorinBound(matrix);
    if (!(bound > 0)) return 0;
    const RitzPair pair = estimate(matrix, tolerance);
    return std::min(bound, pair.value + pair.residual);
}

Eigenpair largestEigenpair(const SymmetricSum& matrix, double tolerance) {
    const double bound = gershgorinBound(matrix);
    if (!(bound > 0)) return {0, {}};
    const RitzPair pair = estimate(matrix, tolerance);
    return {std::min(bound, pair.value + pair.residual),
            ritzVector(pair, matrix, arbitraryDirection(matrix.rows()))};
}

} // namespace esm

#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <utility>

namespace esm {

/// A symmetric matrix: a sparse one, of which the lower half is stored, and factor·C·Cᵀ, of as low a rank as
/// C has columns. Nothing else here asks more of a matrix than products.
struct SymmetricSum {
    Eigen::SparseMatrix<double> lower;
    Eigen::MatrixXd columns; ///< C; none: nothing is added
    double factor;

    SymmetricSum(const Eigen::SparseMatrix<double>& sparse = {}, Eigen::MatrixXd lowRank = {},
                 double lowRankFactor = 1)
        : lower(sparse), columns(std::move(lowRank)), factor(lowRankFactor) {}

    Eigen::Index rows() const { return lower.rows(); }
    Eigen::VectorXd times(const Eigen::VectorXd& x) const {
        Eigen::VectorXd product = lower.selfadjointView<Eigen::Lower>() * x;
        if (columns.cols() > 0) product += factor * (columns * (columns.transpose() * x));
        return product;
    }
    Eigen::VectorXd diagonal() const {
        Eigen::VectorXd result = lower.diagonal();
        if (columns.cols() > 0) result += factor * columns.rowwise().squaredNorm();
        return result;
    }
};

/// S·A·S with a diagonal S.
inline SymmetricSum scaled(const SymmetricSum& sum, const Eigen::VectorXd& scale) {
    SymmetricSum result(Eigen::SparseMatrix<double>(scale.asDiagonal() * sum.lower * scale.asDiagonal()), {},
                        sum.factor);
    if (sum.columns.cols() > 0) result.columns = scale.asDiagonal() * sum.columns;
    return result;
}

} // namespace esm

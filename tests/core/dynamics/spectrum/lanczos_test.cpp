#include "core/dynamics/spectrum/lanczos.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

/// The stiffness of a chain whose springs differ, and something negative on its diagonal.
Eigen::SparseMatrix<double> unevenChain(int size) {
    Eigen::SparseMatrix<double> lower(size, size);
    for (int i = 0; i < size; ++i) {
        lower.insert(i, i) = 2 + std::sin(3.1 * i) - 5 * (i % 7 == 0);
        if (i + 1 < size) lower.insert(i + 1, i) = -1 - 0.5 * std::cos(1.7 * i);
    }
    return lower;
}

Eigen::VectorXd exactEigenvalues(const Eigen::SparseMatrix<double>& lower) {
    const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    return dense.selfadjointView<Eigen::Lower>().eigenvalues();
}

LanczosLimits residualBelow(double most) {
    return {[most](const RitzPair& pair) { return pair.residual < most; }, 1, 200};
}

} // namespace

TEST(LargestRitzPair, IsWithinItsResidualBelowTheLargestEigenvalue) {
    const auto matrix = unevenChain(60);
    const double expected = exactEigenvalues(matrix).maxCoeff();
    for (const double residual : {1e-1, 1e-3, 1e-6}) {
        const RitzPair pair = largestRitzPair(matrix, arbitraryDirection(60), residualBelow(residual));
        EXPECT_LT(pair.residual, residual);
        EXPECT_LE(pair.value, expected + 1e-12);
        EXPECT_GT(pair.value, expected - residual);
    }
}

TEST(LargestRitzPair, HasTheVectorOfItsValue) {
    const auto matrix = unevenChain(60);
    const Eigen::VectorXd start = arbitraryDirection(60);
    const RitzPair pair = largestRitzPair(matrix, start, residualBelow(1e-7));
    const Eigen::VectorXd vector = ritzVector(pair, matrix, start);
    EXPECT_NEAR(vector.norm(), 1, 1e-12);
    const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Lower>() * vector;
    EXPECT_LT((product - pair.value * vector).norm(), 1e-6);
}

TEST(LargestRitzPair, IsExactOnceTheMatrixMakesNothingNewOfTheStart) {
    Eigen::SparseMatrix<double> diagonal(4, 4);
    for (int i = 0; i < 4; ++i)
        diagonal.insert(i, i) = -1.0 - i;
    const RitzPair pair = largestRitzPair(diagonal, arbitraryDirection(4), residualBelow(0));
    EXPECT_NEAR(pair.value, -1, 1e-12);
    const RitzPair alone = largestRitzPair(diagonal, Eigen::VectorXd::Unit(4, 2), residualBelow(0));
    EXPECT_NEAR(alone.value, -3, 1e-12);
    EXPECT_NEAR(std::abs(ritzVector(alone, diagonal, Eigen::VectorXd::Unit(4, 2))[2]), 1, 1e-12);
}

TEST(LargestRitzPair, TakesAsManyIterationsAsItIsGiven) {
    const auto matrix = unevenChain(400);
    for (const int iterations : {1, 7, 30}) {
        const LanczosLimits limits{[](const RitzPair&) { return false; }, 1, iterations};
        EXPECT_EQ(largestRitzPair(matrix, arbitraryDirection(400), limits).coefficients.size(), iterations);
    }
}

TEST(IterationsToNotice, SufficeForASingleEigenvalueAmongVeryMany) {
    constexpr int size = 20000;
    constexpr double share = 0.01;
    Eigen::SparseMatrix<double> diagonal(size, size);
    for (int i = 0; i < size; ++i)
        diagonal.insert(i, i) = i == 777 ? 1 + share : i / (size - 1.0);
    const LanczosLimits limits{[](const RitzPair&) { return true; }, iterationsToNotice(share, size), 10000};
    const RitzPair pair = largestRitzPair(diagonal, arbitraryDirection(size), limits);
    EXPECT_GT(pair.value, 1);
    EXPECT_LT(pair.coefficients.size(), 60);
}

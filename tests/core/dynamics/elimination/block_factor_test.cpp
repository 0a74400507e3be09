#include "core/dynamics/elimination/block_factor.h"

#include "tests/support/rounds.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace esm;

namespace {

using Eigen::Vector3d;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// A symmetric matrix whose rows lie in a box and are coupled to some that are near, and to a few anywhere.
struct Sample {
    SparseMatrix lower;
    std::vector<Vector3d> places;

    Eigen::MatrixXd dense() const { return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>(); }
};

/// @param definite else the last row makes the matrix indefinite
Sample sampleOf(int rows, std::uint32_t seed, bool definite = true) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    Sample sample;
    for (int row = 0; row < rows; ++row)
        sample.places.emplace_back(unit(random), 2 * unit(random), 0.5 * unit(random));
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> diagonal(sample.places.size(), 1e-3);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < row; ++column) {
            const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
            if ((sample.places[r] - sample.places[c]).norm() > 0.3 && unit(random) > 1.0 / rows / rows)
                continue;
            const double value = 0.1 + unit(random);
            entries.emplace_back(row, column, -value);
            diagonal[r] += value;
            diagonal[c] += value;
        }
    if (!definite) diagonal.back() *= -1;
    for (int row = 0; row < rows; ++row)
        entries.emplace_back(row, row, diagonal[static_cast<std::size_t>(row)]);
    sample.lower.resize(rows, rows);
    sample.lower.setFromTriplets(entries.begin(), entries.end());
    return sample;
}

std::optional<BlockFactor> factorOf(const Sample& sample) {
    return BlockFactor::of(sample.lower,
                           std::make_shared<const FactorPlan>(planFactor(sample.lower, sample.places)));
}

std::vector<Vector3d> someVectors(std::size_t count) {
    std::vector<Vector3d> vectors;
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<double>(i);
        vectors.emplace_back(std::sin(n), std::cos(2 * n), std::sin(5 * n + 1));
    }
    return vectors;
}

Eigen::MatrixX3d stacked(const std::vector<Vector3d>& vectors) {
    Eigen::MatrixX3d rows(vectors.size(), 3);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = vectors[i];
    return rows;
}

/// The matrix with its rows in the factor's order.
Eigen::MatrixXd inFactorsOrder(const Sample& sample, const BlockFactor& factor) {
    const Eigen::MatrixXd dense = sample.dense();
    Eigen::MatrixXd result(dense.rows(), dense.cols());
    const std::vector<int>& places = factor.places();
    for (Eigen::Index row = 0; row < dense.rows(); ++row)
        for (Eigen::Index column = 0; column < dense.cols(); ++column)
            result(places[static_cast<std::size_t>(row)], places[static_cast<std::size_t>(column)]) =
                dense(row, column);
    return result;
}

} // namespace

TEST(BlockFactor, SolvesAsADenseFactorDoes) {
    for (int round = 0; round < roundsOf(6, 100); ++round) {
        SCOPED_TRACE(seedOf(round));
        const Sample sample = sampleOf(20 + 60 * round % 400, seedOf(round));
        const auto factor = factorOf(sample);
        ASSERT_TRUE(factor);
        const Eigen::MatrixXd lower = inFactorsOrder(sample, *factor).llt().matrixL();
        const std::vector<Vector3d> vectors = someVectors(factor->rowCount());
        const auto isNear = [&](const std::vector<Vector3d>& found, const Eigen::MatrixX3d& expected) {
            return (stacked(found) - expected).norm() <= 1e-11 * expected.norm();
        };
        std::vector<Vector3d> half = vectors, whole = vectors;
        factor->solveLower(half);
        factor->solveUpper(whole);
        EXPECT_TRUE(isNear(half, lower.triangularView<Eigen::Lower>().solve(stacked(vectors))));
        EXPECT_TRUE(isNear(whole, lower.transpose().triangularView<Eigen::Upper>().solve(stacked(vectors))));
        EXPECT_TRUE(isNear(factor->multiplyUpper(vectors), lower.transpose() * stacked(vectors)));
    }
}

TEST(BlockFactor, GivesColumnsOfTheInverseOfItsLowerHalf) {
    const Sample sample = sampleOf(150, 3);
    const auto factor = factorOf(sample);
    ASSERT_TRUE(factor);
    const Eigen::MatrixXd lower = inFactorsOrder(sample, *factor).llt().matrixL();
    const Eigen::MatrixXd inverse =
        lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(150, 150));
    std::vector<int> rows(150);
    std::iota(rows.begin(), rows.end(), 0);
    const std::vector<HalfColumn> columns = factor->halfColumns(rows);
    for (int row = 0; row < 150; ++row) {
        const HalfColumn& column = columns[static_cast<std::size_t>(row)];
        EXPECT_EQ(column.rows.front(), row);
        EXPECT_EQ(column.values, factor->halfColumns({row}).front().values) << "alone";
        Eigen::VectorXd found = Eigen::VectorXd::Zero(150);
        for (std::size_t i = 0; i < column.rows.size(); ++i)
            found[column.rows[i]] = column.values[i];
        EXPECT_LT((found - inverse.col(row)).norm(), 1e-11 * inverse.col(row).norm()) << row;
    }
}

TEST(BlockFactor, IsNoneOfWhatIsNotPositiveDefinite) {
    EXPECT_FALSE(factorOf(sampleOf(90, 1, false)));
}

TEST(BlockFactor, OfFewRowsAndOfNone) {
    const auto one = factorOf(sampleOf(1, 1));
    ASSERT_TRUE(one);
    std::vector<Vector3d> vectors{{1, 2, 3}};
    one->solveLower(vectors);
    one->solveUpper(vectors);
    EXPECT_LT((vectors[0] - 1e3 * Vector3d(1, 2, 3)).norm(), 1e-9);
    std::vector<Vector3d> nothing;
    const auto none = factorOf(sampleOf(0, 1));
    ASSERT_TRUE(none);
    none->solveLower(nothing);
    EXPECT_EQ(none->rowCount(), 0U);
}

// A plan serves all matrices with entries in the same places.
TEST(BlockFactor, ComputesAnewByAPlanThatItHasUsed) {
    Sample sample = sampleOf(200, 5);
    const auto plan = std::make_shared<const FactorPlan>(planFactor(sample.lower, sample.places));
    const auto before = BlockFactor::of(sample.lower, plan);
    sample.lower *= 4;
    const auto after = BlockFactor::of(sample.lower, plan);
    ASSERT_TRUE(before && after);
    std::vector<Vector3d> one = someVectors(200), other = someVectors(200);
    before->solveLower(one);
    after->solveLower(other);
    EXPECT_LT((stacked(one) - 2 * stacked(other)).norm(), 1e-12 * stacked(one).norm());
}

#include "core/dynamics/spectrum/largest_eigenvalue.h"
#include "core/dynamics/step_matrix.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace esm;

namespace {

Eigen::SparseMatrix<double> stiffnessOf(const TissueModel& model) {
    const SpringSystem system = makeSpringSystem(model);
    return laplacianMatrix(system, {0, 0, 1}, system.fixed);
}

double exact(const Eigen::SparseMatrix<double>& lower) {
    const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    return dense.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
}

} // namespace

TEST(LargestEigenvalue, IsEstimatedFromAboveWithinAThousandth) {
    TissueModel uneven = tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0, 1});
    for (std::size_t i = 0; i < uneven.mass.size(); ++i)
        uneven.springConstant[i] *= std::exp(3 * std::sin(7 * static_cast<double>(i)));
    uneven.tethers = {{4, 300, 0}};
    for (const TissueModel& model :
         {tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0, 1}),
          tissue::fromMesh(tissue::sphereMesh(2, 0.05), {1e-6, 0, 1}), uneven, tissue::fallopianTube()}) {
        const auto matrix = stiffnessOf(model);
        const double expected = exact(matrix), found = largestEigenvalue(matrix);
        EXPECT_GE(found, (1 - 1e-9) * expected);
        EXPECT_LE(found, (1 + 1e-3) * expected);
    }
}

TEST(LargestEigenvalue, OfTwoMassesOnASpringIsKnown) {
    // [[c, −c], [−c, c]] has the eigenvalues 0 and 2c.
    EXPECT_NEAR(largestEigenvalue(stiffnessOf(tissue::oneSpring({7, 0, 1}))), 14, 1e-9);
}

TEST(LargestEigenvalue, OfNothingIsZero) {
    EXPECT_EQ(largestEigenvalue(Eigen::SparseMatrix<double>(0, 0)), 0);
    EXPECT_EQ(largestEigenvalue(Eigen::SparseMatrix<double>(5, 5)), 0);
}

TEST(LargestEigenpair, HasTheVectorOfTheEstimate) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {10, 0, 1});
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        model.springConstant[i] *= 1 + 0.3 * std::sin(static_cast<double>(i));
    const auto matrix = stiffnessOf(model);
    const double expected = exact(matrix);
    const Eigenpair found = largestEigenpair(matrix, 5e-4);
    EXPECT_EQ(found.value, largestEigenvalue(matrix, 5e-4));
    const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Lower>() * found.vector;
    EXPECT_LT((product - expected * found.vector).norm(), 1e-2 * expected);
    EXPECT_EQ(largestEigenpair(Eigen::SparseMatrix<double>(5, 5), 5e-4).value, 0);
}

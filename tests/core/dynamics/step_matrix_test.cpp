#include "core/dynamics/step_matrix.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

SpringSystem unevenSystem() {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(6, 0.1), {10, 0.5, 0.001});
    for (std::size_t i = 0; i < model.mass.size(); ++i) {
        const auto n = static_cast<double>(i);
        model.mass[i] *= std::exp(std::sin(n));
        model.viscosity[i] *= std::exp(2 * std::cos(3 * n));
    }
    model.tethers = {{0, 1, 0.2}, {20, 1, 3}};
    return makeSpringSystem(model);
}

/// massFactor·M + dampingFactor·D over all nodes, from the definition.
Eigen::MatrixXd denseMatrix(const SpringSystem& system, double massFactor, double dampingFactor) {
    const auto size = static_cast<Eigen::Index>(system.mass.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        matrix(i, i) = massFactor * system.mass[static_cast<std::size_t>(i)];
    for (const auto& spring : system.springs) {
        const double d = dampingFactor * spring.viscosity;
        matrix(spring.first, spring.first) += d;
        matrix(spring.second, spring.second) += d;
        matrix(spring.first, spring.second) -= d;
        matrix(spring.second, spring.first) -= d;
    }
    for (const Tether& tether : system.tethers)
        matrix(tether.node, tether.node) += dampingFactor * tether.viscosity;
    return matrix;
}

Vectors someVectors(std::size_t count) {
    Vectors vectors;
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<double>(i);
        vectors.emplace_back(std::sin(n), std::cos(2 * n), std::sin(5 * n + 1));
    }
    return vectors;
}

} // namespace

TEST(StepMatrix, SolvesForTheVelocitiesThatAreNotPrescribed) {
    const SpringSystem system = unevenSystem();
    std::vector<char> given(system.mass.size(), 0);
    given[3] = given[14] = given[35] = 1;
    MatrixFactoriser factoriser;
    const StepMatrix matrix(system, {1.5, 0.02, 0}, given, factoriser);
    const Vectors momentum = someVectors(system.mass.size());
    Vectors velocities(momentum.size(), Eigen::Vector3d(1, -2, 3)), half;
    matrix.solveLower(momentum, velocities, half);
    matrix.solveUpper(half, velocities);

    const Eigen::MatrixXd dense = denseMatrix(system, 1.5, 0.02);
    for (std::size_t i = 0; i < momentum.size(); ++i) {
        EXPECT_EQ(matrix.isGiven(static_cast<std::uint32_t>(i)), given[i] != 0);
        if (given[i]) {
            EXPECT_EQ(velocities[i], Eigen::Vector3d(1, -2, 3));
            continue;
        }
        Eigen::Vector3d product = Eigen::Vector3d::Zero();
        for (std::size_t j = 0; j < momentum.size(); ++j)
            product += dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * velocities[j];
        EXPECT_LT((product - momentum[i]).norm(), 1e-11) << i;
    }
}

TEST(StepMatrix, GivesColumnsWhoseProductsAreItsInverse) {
    const SpringSystem system = unevenSystem();
    MatrixFactoriser factoriser;
    const StepMatrix matrix(system, {1, 0.02, 0}, std::vector<char>(system.mass.size(), 0), factoriser);
    const Eigen::MatrixXd inverse = denseMatrix(system, 1, 0.02).inverse();
    for (const std::uint32_t a : {0U, 7U, 35U})
        for (const std::uint32_t b : {0U, 8U, 21U}) {
            const auto columns = matrix.halfColumns({a, b});
            const HalfColumn &first = columns[0], &second = columns[1];
            double product = 0;
            for (std::size_t i = 0; i < first.rows.size(); ++i)
                for (std::size_t j = 0; j < second.rows.size(); ++j)
                    if (first.rows[i] == second.rows[j]) product += first.values[i] * second.values[j];
            EXPECT_NEAR(product, inverse(a, b), 1e-9 * inverse(a, a)) << a << " " << b;
        }
}

TEST(StepMatrix, IsTheMassesAloneWithoutDamping) {
    const SpringSystem system = unevenSystem();
    MatrixFactoriser factoriser;
    const StepMatrix matrix(system, {1, 0, 0}, std::vector<char>(system.mass.size(), 0), factoriser);
    const Vectors momentum = someVectors(system.mass.size());
    Vectors velocities(momentum.size()), half;
    matrix.solveLower(momentum, velocities, half);
    matrix.solveUpper(half, velocities);
    for (std::size_t i = 0; i < momentum.size(); ++i)
        EXPECT_LT((velocities[i] - momentum[i] / system.mass[i]).norm(), 1e-9);
}

TEST(StepMatrix, OfNothingButPrescribedNodesHasNothingToSolve) {
    const SpringSystem system = unevenSystem();
    MatrixFactoriser factoriser;
    const StepMatrix matrix(system, {1, 0.02, 0}, std::vector<char>(system.mass.size(), 1), factoriser);
    const Vectors given = someVectors(system.mass.size());
    Vectors velocities = given, half;
    matrix.solveLower(given, velocities, half);
    matrix.solveUpper(half, velocities);
    EXPECT_EQ(velocities, given);
}

TEST(StepMatrix, RefusesMassesThatViscositySwallows) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(6, 0.1), {10, 1e12, 1e-9});
    MatrixFactoriser factoriser;
    EXPECT_THROW(StepMatrix(makeSpringSystem(model), {1, 0.01, 0}, std::vector<char>(model.mass.size(), 0),
                            factoriser),
                 InvalidModel);
}

TEST(MatrixFactoriser, FindsTheSameWithWhatItKnowsAsWithout) {
    SpringSystem system = unevenSystem();
    MatrixFactoriser used;
    Vectors places = system.network->restPositions;
    const auto isSame = [&](const std::vector<char>& given) {
        const Eigen::SparseMatrix<double> matrix = laplacianMatrix(system, {1, 0.02, 0}, given);
        const Vectors free(places.end() - matrix.rows(), places.end());
        MatrixFactoriser fresh;
        const auto known = used.factorise(matrix, free), anew = fresh.factorise(matrix, free);
        Vectors knownHalf = someVectors(known->rowCount()), half = knownHalf;
        known->solveLower(knownHalf);
        anew->solveLower(half);
        return knownHalf == half && known->places() == anew->places();
    };
    std::vector<char> given(system.mass.size(), 0);
    EXPECT_TRUE(isSame(given));
    for (SpringSystem::Element& spring : system.springs)
        spring.viscosity *= 1 + spring.first;
    EXPECT_TRUE(isSame(given)) << "other parameters";
    for (Eigen::Vector3d& place : places)
        place = {place.y(), 3 * place.x() + place.y(), 1};
    EXPECT_TRUE(isSame(given)) << "other places";
    system.springs[3].viscosity = 0;
    EXPECT_TRUE(isSame(given)) << "an entry less";
    given[7] = 1;
    EXPECT_TRUE(isSame(given)) << "a node less";
}

TEST(LaplacianMatrix, LeavesPrescribedNodesOut) {
    const SpringSystem system = unevenSystem();
    std::vector<char> given(system.mass.size(), 0);
    given[0] = 1;
    const auto sparse = laplacianMatrix(system, {2, 3, 0}, given);
    const Eigen::MatrixXd lower = Eigen::MatrixXd(sparse);
    const Eigen::MatrixXd dense = denseMatrix(system, 2, 3);
    const Eigen::Index size = dense.rows() - 1;
    ASSERT_EQ(lower.rows(), size);
    const Eigen::MatrixXd expected = dense.bottomRightCorner(size, size);
    EXPECT_LT((Eigen::MatrixXd(lower.triangularView<Eigen::Lower>()) -
               Eigen::MatrixXd(expected.triangularView<Eigen::Lower>()))
                  .norm(),
              1e-12);
}

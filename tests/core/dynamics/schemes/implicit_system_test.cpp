#include "core/dynamics/forces.h"
#include "core/dynamics/schemes/implicit_system.h"
#include "core/dynamics/spectrum/rest_matrix.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Vectors;

namespace {

Vectors waves(std::size_t count, double size) {
    Vectors result;
    for (std::size_t i = 0; i < count; ++i) {
        const auto t = static_cast<double>(i);
        result.emplace_back(size * std::sin(3.1 * t), size * std::cos(1.7 * t), size * std::sin(0.9 * t + 1));
    }
    return result;
}

Vectors sum(const Vectors& a, double factor, const Vectors& b) {
    Vectors result = a;
    for (std::size_t i = 0; i < a.size(); ++i)
        result[i] += factor * b[i];
    return result;
}

double largestDifference(const Vectors& a, const Vectors& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

SpringSystem tetheredSphere() {
    TissueModel model = tissue::fromMesh(tissue::sphereMesh(2, 0.05), {10, 0.3, 0.001});
    model.tethers = {{3, 7, 0.4}, {20, 2, 0.1}};
    return makeSpringSystem(model);
}

/// Beyond a twentieth every other spring becomes stiffer, the rest softer.
SpringSystem biphasicSphere() {
    SpringSystem system = tetheredSphere();
    for (std::size_t i = 0; i < system.springs.size(); ++i)
        system.springs[i].secondPhase = {0.05, i % 2 == 0 ? 100.0 : 3.0};
    return system;
}

/// M·v + 0.01·D·v + 0.0001·K·v by finite differences of the forces.
Vectors product(const SpringSystem& system, Damping damping, const Vectors& positions, const Vectors& v) {
    constexpr double small = 1e-6;
    Vectors forward, backward, damped(v.size(), Eigen::Vector3d::Zero());
    elasticForces(system, sum(positions, small, v), forward);
    elasticForces(system, sum(positions, -small, v), backward);
    addDampingForces(system, damping, positions, v, damped);
    Vectors result;
    for (std::size_t i = 0; i < v.size(); ++i)
        result.emplace_back(system.mass[i] * v[i] - 0.01 * damped[i] -
                            0.0001 * (forward[i] - backward[i]) / (2 * small));
    return result;
}

constexpr MatrixFactors factors{1, 0.01, 0.0001};

} // namespace

TEST(TangentMatrix, IsTheDerivativeOfTheForces) {
    for (const SpringSystem& system : {tetheredSphere(), biphasicSphere()}) {
        const std::size_t count = system.mass.size();
        const Vectors positions = sum(system.network->restPositions, 1, waves(count, 0.005));
        for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
            const Vectors v = waves(count, 1);
            Vectors result;
            TangentMatrix(system, damping, factors, positions).multiply(v, result);
            EXPECT_LT(largestDifference(result, product(system, damping, positions, v)), 1e-8);
        }
    }
}

TEST(TangentMatrix, SolvesForTheVelocitiesThatAreNotGiven) {
    SpringSystem system = tetheredSphere();
    system.fixed[5] = 1;
    const std::size_t count = system.mass.size();
    const Vectors positions = sum(system.network->restPositions, 1, waves(count, 0.002)),
                  momentum = waves(count, 0.001);
    MatrixFactoriser factoriser;
    const StepMatrix preconditioner(system, factors, system.fixed, factoriser);
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        TangentMatrix matrix(system, damping, factors, positions);
        Vectors velocities(count, Eigen::Vector3d::Zero()), result;
        velocities[8] = {0.1, 0.2, -0.3};
        solveImplicit(matrix, preconditioner, {{8, {0, 0, 0}}}, momentum, velocities);
        EXPECT_EQ(velocities[8], Eigen::Vector3d(0.1, 0.2, -0.3));
        EXPECT_EQ(velocities[5], Eigen::Vector3d::Zero());
        matrix.multiply(velocities, result);
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 5 || i == 8) continue;
            EXPECT_LT((result[i] - momentum[i]).norm(), 1e-10) << i;
        }
    }
}

// Pressed to a third, springs buckle: the tangent has negative curvature, and the step must still be found.
TEST(TangentMatrix, FindsAStepWherePressedSpringsBuckle) {
    const SpringSystem system =
        makeSpringSystem(tissue::fromMesh(tissue::sphereMesh(2, 0.05), {1e5, 0, 0.001}));
    Vectors positions = system.network->restPositions;
    for (Eigen::Vector3d& position : positions)
        position *= 0.33;
    const MatrixFactors stiff{1, 0.01, 0.01};
    MatrixFactoriser factoriser;
    const StepMatrix preconditioner(system, stiff, system.fixed, factoriser);
    TangentMatrix matrix(system, Damping::Isotropic, stiff, positions);
    const Vectors momentum = waves(positions.size(), 0.001);
    Vectors velocities(positions.size(), Eigen::Vector3d::Zero()), result;
    solveImplicit(matrix, preconditioner, {}, momentum, velocities);
    matrix.multiply(velocities, result);
    EXPECT_LT(largestDifference(result, momentum), 1e-9);
}

TEST(RestMatrix, IsTheTangentAtRest) {
    SpringSystem system = tetheredSphere();
    system.fixed[5] = 1;
    const std::size_t count = system.mass.size();
    Vectors v = waves(count, 1);
    v[5].setZero();
    for (const Damping damping : {Damping::Isotropic, Damping::Axial}) {
        Vectors expected;
        TangentMatrix(system, damping, factors, system.network->restPositions).multiply(v, expected);
        const Eigen::SparseMatrix<double> matrix = restMatrix(system, damping, factors);
        Eigen::VectorXd packed(matrix.rows());
        Eigen::Index row = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (i != 5) packed.segment<3>(row) = v[i], row += 3;
        ASSERT_EQ(row, matrix.rows());
        const Eigen::VectorXd result = matrix.selfadjointView<Eigen::Lower>() * packed;
        row = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 5) continue;
            EXPECT_LT((result.segment<3>(row) - expected[i]).norm(), 1e-12) << i;
            row += 3;
        }
    }
}

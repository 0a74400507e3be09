#include "core/dynamics/simulation.h"
#include "tests/support/lattice_block.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

using namespace esm;

namespace {

using Eigen::Vector3d;

/// A body-centred block that nothing holds.
TissueModel freeBlock(double width) {
    const test::LatticeBlock block = test::latticeBlock(LatticeKind::BodyCentred, width, true);
    SpringNetwork network;
    for (const Vector3d& node : block.nodes)
        network.restPositions.emplace_back(0.01 * node);
    for (const LatticeSpring& spring : block.springs)
        tissue::addSpring(network, spring.first, spring.second);
    TissueModel model = tissue::model(std::move(network), {16.26, 2.877, 1e-4});
    for (std::size_t i = 0; i < model.mass.size(); ++i)
        model.mass[i] *= 1 + 0.5 * std::sin(static_cast<double>(i));
    return model;
}

Loads pullAt(std::uint32_t node) {
    Loads loads;
    loads.forces = {{node, {0.01, 0.02, -0.03}}};
    return loads;
}

class SolidTissue : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, SolidTissue,
                         testing::Values(Integrator::Split, Integrator::Split2, Integrator::Bdf2),
                         [](const auto& info) { return std::string(integratorName(info.param)); });

} // namespace

TEST_P(SolidTissue, TakesUpTheMomentumOfAForceAndKeepsIt) {
    const TissueModel model = freeBlock(8);
    Simulation simulation(model, withStep(GetParam(), 0.005));
    const auto momentum = [&] {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t i = 0; i < model.mass.size(); ++i)
            sum += model.mass[i] * simulation.velocities()[i];
        return sum;
    };
    const Loads pull = pullAt(11);
    ASSERT_EQ(simulation.advance(pull, 1), 1U) << simulation.failure();
    const Vector3d given = 0.005 * pull.forces[0].second;
    EXPECT_LT((momentum() - given).norm(), 1e-8 * given.norm());
    Loads none;
    none.beginsAnew = true;
    ASSERT_TRUE(simulation.step(none)) << simulation.failure();
    ASSERT_EQ(simulation.advance({}, 40), 40U) << simulation.failure();
    EXPECT_LT((momentum() - given).norm(), 1e-6 * given.norm());
}

TEST_P(SolidTissue, MovesTheSameOnAnyNumberOfThreads) {
    const TissueModel model = freeBlock(8);
    const auto moved = [&](std::size_t threads) {
        SimulationSettings settings = withStep(GetParam(), 0.005);
        settings.threads = threads;
        Simulation simulation(model, settings);
        simulation.advance(pullAt(3), 20);
        return simulation.positions();
    };
    EXPECT_EQ(moved(1), moved(4));
}

// The step as it is written, (M + h·D)·v = M·v₀ + h·F, solved as a dense system.
TEST(SolidBlock, StepsAsADenseSolutionDoes) {
    const TissueModel model = freeBlock(5);
    const SpringSystem system = makeSpringSystem(model);
    const auto size = static_cast<Eigen::Index>(system.mass.size());
    ASSERT_GT(size, 150);
    constexpr double step = 0.01;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        matrix(i, i) = system.mass[static_cast<std::size_t>(i)];
    for (const auto& spring : system.springs) {
        Eigen::VectorXd difference = Eigen::VectorXd::Zero(size);
        difference[spring.first] = 1;
        difference[spring.second] = -1;
        matrix.selfadjointView<Eigen::Lower>().rankUpdate(difference, step * spring.viscosity);
    }
    const Loads pull = pullAt(17);
    Eigen::MatrixX3d impulse = Eigen::MatrixX3d::Zero(size, 3);
    impulse.row(17) = step * pull.forces[0].second.transpose();
    const Eigen::MatrixX3d velocities = matrix.selfadjointView<Eigen::Lower>().llt().solve(impulse);
    Simulation simulation(model, withStep(Integrator::Split, step));
    ASSERT_TRUE(simulation.step(pull)) << simulation.failure();
    for (Eigen::Index i = 0; i < size; ++i)
        EXPECT_LT(
            (simulation.velocities()[static_cast<std::size_t>(i)] - velocities.row(i).transpose()).norm(),
            1e-10 * velocities.norm());
}

TEST(SolidBlock, IsSolvedForToRounding) {
    const SpringSystem system = makeSpringSystem(freeBlock(15));
    const std::vector<char> given(system.mass.size(), 0);
    MatrixFactoriser factoriser;
    for (const MatrixFactors& factors : {MatrixFactors{1, 1e-3, 0}, {1, 0.01, 1e-4}, {1.5, 10, 0}}) {
        const auto lower = laplacianMatrix(system, factors, given);
        const StepMatrix matrix(system, factors, given, factoriser);
        Vectors momentum, velocities(system.mass.size()), half;
        for (std::size_t i = 0; i < velocities.size(); ++i) {
            const auto n = static_cast<double>(i);
            momentum.emplace_back(std::sin(n), std::cos(2 * n), std::sin(5 * n));
        }
        matrix.solveLower(momentum, velocities, half);
        matrix.solveUpper(std::move(half), velocities);
        Eigen::MatrixX3d solved(velocities.size(), 3), asked(velocities.size(), 3);
        for (Eigen::Index i = 0; i < solved.rows(); ++i) {
            solved.row(i) = velocities[static_cast<std::size_t>(i)];
            asked.row(i) = momentum[static_cast<std::size_t>(i)];
        }
        const Eigen::MatrixX3d missing = lower.selfadjointView<Eigen::Lower>() * solved - asked;
        const double largest = 30 * factors.damping * 2.877 + 30 * factors.stiffness * 16.26;
        EXPECT_LT(missing.norm(), 1e-14 * (largest * solved.norm() + asked.norm()));
    }
}

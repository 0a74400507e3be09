#include "core/dynamics/simulation.h"
#include "tests/support/every_integrator.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <future>

using namespace esm;

namespace {

constexpr double stepBefore = 1e-3; // s

/// A membrane that gravity pulls aside, held at one edge.
class GoingBack : public testing::TestWithParam<Integrator> {
protected:
    static TissueModel model() {
        TissueModel membrane = tissue::fromMesh(tissue::gridMesh(8, 0.1), {10, 0.01, 0.001});
        for (std::uint32_t node = 0; node < 8; ++node)
            membrane.fixedNodes.push_back(node);
        return membrane;
    }
    void take(std::size_t steps) {
        Loads loads;
        loads.gravity = {0, 9.81, 0};
        ASSERT_EQ(simulation.advance(loads, steps), steps) << simulation.failure();
    }

    Simulation simulation{model(), withStep(GetParam(), stepBefore)};
};

} // namespace

TEST_P(GoingBack, ReturnsToTheOlderOfTwoKeptStatesAndGoesOnFromThere) {
    take(20);
    simulation.keepState();
    const auto kept = simulation.positions(), velocities = simulation.velocities();
    take(10);
    simulation.keepState();
    take(10);
    simulation.goBack(stepBefore / 2);
    EXPECT_EQ(simulation.positions(), kept);
    EXPECT_EQ(simulation.velocities(), velocities);
    EXPECT_DOUBLE_EQ(simulation.time(), 20 * stepBefore);
    EXPECT_EQ(simulation.timeStep(), stepBefore / 2);
    EXPECT_EQ(simulation.integrator(), GetParam());
    take(20);
    EXPECT_DOUBLE_EQ(simulation.time(), 30 * stepBefore);
}

TEST_P(GoingBack, ReturnsToTheSameStateWhenItGoesBackAgainSoon) {
    take(20);
    simulation.keepState();
    const auto kept = simulation.positions();
    take(10);
    simulation.keepState();
    simulation.goBack(stepBefore / 2);
    take(10);
    simulation.keepState();
    take(10);
    simulation.goBack(stepBefore / 4);
    EXPECT_EQ(simulation.positions(), kept);
    EXPECT_DOUBLE_EQ(simulation.time(), 20 * stepBefore);
}

TEST_P(GoingBack, StartsFromRestWhereTooLittleWasKept) {
    take(20);
    simulation.keepState();
    take(20);
    simulation.goBack(stepBefore / 2);
    EXPECT_EQ(simulation.positions(), model().network->restPositions);
    EXPECT_EQ(simulation.time(), 0);
    EXPECT_EQ(simulation.timeStep(), stepBefore / 2);
}

TEST_P(GoingBack, TakesTheChosenStepAgainWithNewParameters) {
    take(20);
    simulation.goBack(stepBefore / 2);
    simulation.setModel(model());
    EXPECT_EQ(simulation.timeStep(), stepBefore);
}

TEST_P(GoingBack, ReturnsToAStateThatWasKeptBeforeNewParameters) {
    take(20);
    simulation.keepState();
    const auto kept = simulation.positions();
    take(10);
    simulation.keepState();
    take(10);
    simulation.setModel(model());
    take(10);
    simulation.goBack(stepBefore / 2);
    EXPECT_EQ(simulation.positions(), kept);
    EXPECT_DOUBLE_EQ(simulation.time(), 20 * stepBefore);
}

TEST_P(GoingBack, ReturnsToWhereNewParametersCameWhenNothingWasKept) {
    take(20);
    const auto before = simulation.positions();
    simulation.setModel(model());
    take(10);
    simulation.keepState();
    simulation.goBack(stepBefore / 2);
    EXPECT_EQ(simulation.positions(), before);
    EXPECT_DOUBLE_EQ(simulation.time(), 20 * stepBefore);
}

TEST_P(GoingBack, KeepsNodesStillThatWereFixedSinceTheStateWasKept) {
    take(20);
    simulation.keepState();
    take(1);
    simulation.keepState();
    TissueModel held = model();
    held.fixedNodes.push_back(40);
    simulation.setModel(held);
    simulation.goBack(stepBefore / 2);
    EXPECT_EQ(simulation.velocities()[40], Eigen::Vector3d(0, 0, 0));
    EXPECT_NE(simulation.velocities()[41], Eigen::Vector3d(0, 0, 0));
}

TEST_P(GoingBack, GoesOnWithOtherSettings) {
    take(20);
    const auto before = simulation.positions();
    simulation.setModel(model(), withStep(Integrator::Bdf2, stepBefore / 3));
    EXPECT_EQ(simulation.positions(), before);
    EXPECT_EQ(simulation.integrator(), Integrator::Bdf2);
    take(1);
    EXPECT_DOUBLE_EQ(simulation.time(), 20 * stepBefore + stepBefore / 3);
    simulation.setModel(model());
    EXPECT_EQ(simulation.integrator(), Integrator::Bdf2);
}

INSTANTIATE_TEST_SUITE_P(Integrators, GoingBack, testing::Values(Integrator::Euler, Integrator::Split2),
                         [](const auto& info) { return std::string(integratorName(info.param)); });

class NewParameters : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, NewParameters, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

// What is kept for the sake of speed changes nothing.
TEST_P(NewParameters, AreSteppedAsByASimulationMadeWithThem) {
    TissueModel soft = tissue::fromMesh(tissue::gridMesh(8, 0.1), {10, 0.01, 0.001});
    soft.fixedNodes = {0, 1, 2, 3, 4, 5, 6, 7};
    TissueModel other = soft;
    for (std::size_t i = 0; i < other.mass.size(); ++i) {
        other.springConstant[i] *= 1 + 0.1 * static_cast<double>(i);
        other.mass[i] *= 1 + 0.01 * static_cast<double>(i);
    }
    other.fixedNodes = {0, 7};
    other.tethers = {{40, 3, 0.2}};
    const SimulationSettings settings = withStep(GetParam(), 5e-4);
    Simulation changed(soft, settings), made(other, settings);
    changed.setModel(other);
    Loads loads;
    loads.gravity = {0, 9.81, 1};
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(changed.step(loads) && made.step(loads));
    EXPECT_EQ(changed.positions(), made.positions());
    EXPECT_EQ(changed.velocities(), made.velocities());
}

// The window prepares them beside the run.
TEST_P(NewParameters, MayBePreparedWhileTheSimulationSteps) {
    TissueModel soft = tissue::fromMesh(tissue::gridMesh(12, 0.1), {10, 0.01, 0.001}), stiff = soft;
    for (double& springConstant : stiff.springConstant)
        springConstant *= 3;
    const SimulationSettings settings = withStep(GetParam(), 5e-4);
    Simulation waiting(soft, settings), changed(soft, settings);
    Loads loads;
    loads.forces = {{5, {0, 0, 0.01}}};
    for (int change = 0; change < 3; ++change) {
        const TissueModel& next = change % 2 ? soft : stiff;
        auto prepared = std::async(std::launch::async, [&] { return prepareModel(next, settings); });
        for (int i = 0; i < 20; ++i)
            ASSERT_TRUE(waiting.step(loads) && changed.step(loads));
        waiting.setModel(prepared.get());
        changed.setModel(next);
    }
    EXPECT_EQ(waiting.positions(), changed.positions());
    EXPECT_EQ(waiting.velocities(), changed.velocities());
    EXPECT_EQ(waiting.factorisationSeconds() > 0, traitsOf(GetParam()).kind == StepKind::Solving);
}

// Matrices are kept for nodes that are led again, and for those that are let go.
TEST_P(NewParameters, LetNodesBeLedAndLetGoAsBefore) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(12, 0.1), {10, 0.01, 0.001});
    const SimulationSettings settings = withStep(GetParam(), 5e-4);
    Simulation keeping(model, settings), anew(model, settings);
    for (const std::uint32_t first : {0U, 0U, 70U, 0U}) {
        Loads loads;
        for (std::uint32_t i = first; i < first + 70; ++i)
            loads.prescribed.push_back({i, keeping.positions()[i] + Eigen::Vector3d(0, 0, 1e-4)});
        for (const Loads& taken : {loads, Loads{}}) {
            anew.setModel(model);
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(keeping.step(taken) && anew.step(taken));
        }
    }
    EXPECT_EQ(keeping.positions(), anew.positions());
}

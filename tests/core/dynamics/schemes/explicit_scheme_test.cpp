#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Vectors;

namespace {

Vectors pulled(const TissueModel& model, const SimulationSettings& settings, int steps) {
    Simulation simulation(model, settings);
    Loads loads;
    loads.gravity = {0, 0, -9.81};
    loads.forces = {{7, {0.02, 0, 0.01}}, {40, {0, -0.01, 0}}};
    for (int i = 0; i < steps; ++i)
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
    return simulation.positions();
}

TissueModel heldSphere(int levels) {
    TissueModel model = tissue::fromMesh(tissue::sphereMesh(levels, 0.05), {10, 0.01, 0.001});
    model.fixedNodes = {0, 1, 2, 3};
    return model;
}

} // namespace

TEST(ExplicitScheme, DoesNotDependOnTheThreads) {
    const TissueModel model = heldSphere(4);
    for (const Integrator integrator : explicitIntegrators())
        for (const Precision precision : {Precision::Double, Precision::Float}) {
            SimulationSettings settings = withStep(integrator, 1e-3);
            settings.precision = precision;
            settings.threads = 1;
            const Vectors alone = pulled(model, settings, 20);
            settings.threads = 3;
            EXPECT_EQ(pulled(model, settings, 20), alone) << integratorName(integrator);
        }
}

TEST(ExplicitScheme, TakesStepsTogetherAsOneByOne) {
    const TissueModel model = heldSphere(2);
    for (const Integrator integrator : explicitIntegrators()) {
        Simulation simulation(model, withStep(integrator, 1e-3));
        Loads loads;
        loads.gravity = {0, 0, -9.81};
        loads.forces = {{7, {0.02, 0, 0.01}}, {40, {0, -0.01, 0}}};
        EXPECT_EQ(simulation.advance(loads, 50), 50U);
        EXPECT_DOUBLE_EQ(simulation.time(), 0.05);
        EXPECT_EQ(simulation.positions(), pulled(model, withStep(integrator, 1e-3), 50))
            << integratorName(integrator);
    }
}

TEST(ExplicitScheme, GoesBackToAGoodStateWhenStepsFail) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {1e6, 0.001, 1e-4});
    Simulation simulation(model, withStep(Integrator::Euler, 0.01));
    Loads loads;
    loads.forces = {{40, {0, 0, 1}}};
    const std::size_t taken = simulation.advance(loads, 1000);
    EXPECT_LT(taken, 1000U);
    EXPECT_FALSE(simulation.failure().empty());
    EXPECT_NEAR(simulation.time(), 0.01 * static_cast<double>(taken), 1e-12);
    EXPECT_LT(boundingBox(simulation.positions()).diagonal().norm(),
              3 * boundingBox(model.network->restPositions).diagonal().norm());
}

TEST(ExplicitScheme, InFloatFollowsDouble) {
    const TissueModel model = heldSphere(2);
    for (const Integrator integrator : explicitIntegrators()) {
        SimulationSettings settings = withStep(integrator, 1e-3);
        const Vectors expected = pulled(model, settings, 200);
        settings.precision = Precision::Float;
        const Vectors result = pulled(model, settings, 200);
        double largest = 0, difference = 0;
        for (std::size_t i = 0; i < result.size(); ++i) {
            largest = std::max(largest, (expected[i] - model.network->restPositions[i]).norm());
            difference = std::max(difference, (result[i] - expected[i]).norm());
        }
        EXPECT_GT(largest, 0.01) << integratorName(integrator);
        EXPECT_LT(difference, 1e-4 * largest) << integratorName(integrator);
        EXPECT_GT(difference, 0) << integratorName(integrator);
    }
}

// Each step is shorter than what float can tell of a place.
TEST(ExplicitScheme, InFloatManyShortStepsAddUp) {
    const TissueModel tube = tissue::fallopianTube();
    Loads loads;
    loads.forces = {{85, {0.02, 0.02, 0.1}}};
    for (const Integrator integrator : explicitIntegrators()) {
        if (isSanitized() && integrator != Integrator::Euler) continue; // the others sum alike
        SimulationSettings settings = withStep(integrator, 5e-8);
        Vectors places[2];
        for (const Precision precision : {Precision::Double, Precision::Float}) {
            settings.precision = precision;
            Simulation simulation(tube, settings);
            ASSERT_EQ(simulation.advance(loads, 20000), 20000U);
            places[precision == Precision::Float] = simulation.positions();
        }
        EXPECT_LT(motionDifference(places[1], places[0], tube.network->restPositions), 2e-3)
            << integratorName(integrator);
    }
}

TEST(ExplicitScheme, RefusesFloatWhereItIsNotOffered) {
    SimulationSettings settings;
    settings.precision = Precision::Float;
    EXPECT_EQ(chooseStep(heldSphere(1), settings).integrator, Integrator::Euler);
    settings.integrator = Integrator::Split2;
    EXPECT_EQ(validate(settings).size(), 1U);
}

#include "core/dynamics/measure/scene_run.h"
#include "core/dynamics/simulation.h"
#include "tests/support/analytic_oscillator.h"
#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/reference_motion.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

class Convergence : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, Convergence, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

/// Error at time 1 of one oscillating node, 1 kg and 20 N/m, pulled along its spring by 1 N.
double oscillatorError(Integrator integrator, double damping, int steps) {
    tissue::Parameters parameters{20, damping, 1};
    TissueModel model = tissue::oneSpring(parameters);
    model.fixedNodes = {0};
    Simulation simulation(model, withStep(integrator, 1.0 / steps));
    Loads loads;
    loads.forces = {{1, {1, 0, 0}}};
    for (int i = 0; i < steps; ++i)
        EXPECT_TRUE(simulation.step(loads));
    return std::abs(simulation.positions()[1].x() - 1 - analyticOscillator(1, 20, damping, 1, 1));
}

TEST_P(Convergence, ToTheAnalyticOscillatorIsOfItsOrder) {
    const int order = orderOf(GetParam());
    for (const double damping : {1.0, 2 * std::sqrt(20.0) * 1.0001, 30.0}) {
        // Strongly damped, a fourth-order error soon drowns in rounding.
        const int steps = order < 4 ? 1600 : damping < 20 ? 200 : 60;
        const double coarse = oscillatorError(GetParam(), damping, steps);
        const double fine = oscillatorError(GetParam(), damping, 2 * steps);
        EXPECT_LT(fine, order == 1 ? 5e-4 : 1e-6) << "damping " << damping;
        EXPECT_NEAR(std::log2(coarse / fine), order, order == 4 ? 0.25 : 0.15) << "damping " << damping;
    }
}

/// Two nodes of 10 g that hang in a row on a fixed one, let go at the side: where they are after 0.15 s,
/// having turned by more than half a right angle, their springs stretched.
Vectors fallenAside(Integrator integrator, double timeStep) {
    SpringNetwork network;
    for (int i = 0; i < 3; ++i)
        network.restPositions.emplace_back(0.1 * i, 0, 0.02 * i * i);
    tissue::addSpring(network, 0, 1);
    tissue::addSpring(network, 1, 2);
    TissueModel model = tissue::model(std::move(network), {20, 0.02, 0.01});
    model.fixedNodes = {0};
    Simulation simulation(model, withStep(integrator, timeStep));
    Loads loads;
    loads.gravity = {0, -9.81, 0};
    for (int i = 0; i < std::lround(0.15 / timeStep); ++i)
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
    return simulation.positions();
}

TEST_P(Convergence, IsOfItsOrderWhereTissueTurns) {
    static const Vectors reference = fallenAside(Integrator::Rk4, 1e-5);
    ASSERT_LT(reference[2].y(), -0.07);
    const int order = orderOf(GetParam());
    const double timeStep = order < 4 ? 5e-4 : 1e-3;
    const auto error = [&](double step) { return (fallenAside(GetParam(), step)[2] - reference[2]).norm(); };
    const double coarse = error(timeStep), fine = error(timeStep / 2);
    EXPECT_LT(fine, order == 1 ? 2e-3 : 1e-5);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.25);
}

constexpr double ledTime = 0.1; ///< s
using LedWay = double (*)(double time);

double smoothWay(double time) {
    return 0.02 * (1 - std::cos(25 * time));
}
double wayThatStops(double time) {
    return 0.3 * std::min(time, ledTime / 2);
}

/// Where a net held at one edge is after its corner was led away.
Vectors ledAway(Integrator integrator, int steps, LedWay way) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(4, 0.1), {10, 0.05, 0.001});
    model.fixedNodes = {0, 1, 2, 3};
    Simulation simulation(model, withStep(integrator, ledTime / steps));
    for (int i = 1; i <= steps; ++i) {
        Loads loads;
        loads.prescribed = {
            {15, model.network->restPositions[15] + way(ledTime * i / steps) * Eigen::Vector3d(1, 1, 1)}};
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
    }
    return simulation.positions();
}

TEST_P(Convergence, IsOfItsOrderOrTheSecondWhileNodesAreLed) {
    const int order = std::min(orderOf(GetParam()), 2);
    const Vectors rest = tissue::gridMesh(4, 0.1).vertices;
    for (const LedWay way : {smoothWay, wayThatStops}) {
        const Vectors reference = ledAway(Integrator::Rk4, 8000, way);
        const double coarse = motionDifference(ledAway(GetParam(), 400, way), reference, rest);
        const double fine = motionDifference(ledAway(GetParam(), 800, way), reference, rest);
        EXPECT_LT(fine, order == 1 ? 0.02 : 2e-4);
        EXPECT_GT(std::log2(coarse / fine), order - 0.2);
    }
}

/// A scene whose forces and led node begin, end and turn between steps of any length.
Scene sceneBetweenSteps() {
    Scene scene;
    scene.duration = 0.1;
    scene.record.every = 0.1;
    scene.forces = {{10, {0.01, 0, 0.03}, 0.01713, 0.06127}, {9, {0, 0, -0.1}, 0.03331, 0.03634}};
    scene.moves = {
        {15, {{0.00911, {0, 0, 0}}, {0.04007, {0.002, 0.004, 0.01}}, {0.07301, {0.004, 0, 0.01}}}}};
    return scene;
}

TEST_P(Convergence, IsOfItsOrderWhereLoadsBeginEndAndTurnBetweenSteps) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(4, 0.1), {10, 0.05, 0.001});
    model.fixedNodes = {0, 1, 2, 3};
    const Scene scene = sceneBetweenSteps();
    static const reference::ExactMotion exact = reference::exactMotion({model, scene}, {scene.duration});
    const auto error = [&](double timeStep) {
        Vectors reached;
        runScene({model, {}, scene, withStep(GetParam(), timeStep)},
                 [&](double, const Vectors& positions) { reached = positions; });
        return motionDifference(reached, exact.places.front(), model.network->restPositions);
    };
    // Adams-Moulton is Runge-Kutta while a node is led.
    const int order = orderOf(GetParam());
    const double coarse = error(order < 4 ? 5e-4 : 2e-3), fine = error(order < 4 ? 1.25e-4 : 5e-4);
    EXPECT_LT(fine, order == 1 ? 0.02 : 3e-4);
    EXPECT_GT(std::log2(coarse / fine) / 2, order - 0.3);
}

} // namespace

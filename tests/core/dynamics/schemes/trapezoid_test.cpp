#include "core/dynamics/measure/extremes.h"
#include "core/dynamics/simulation.h"
#include "core/support/errors.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

/// One node of 1 kg on a tether.
TissueModel tethered(double stiffness, double damping) {
    TissueModel model = tissue::oneSpring({0, 0, 1});
    model.tethers = {{1, stiffness, damping}};
    return model;
}

/// m and m/s from its rest, along y.
Eigen::Vector2d stateOf(const Simulation& simulation) {
    return {simulation.positions()[1].y(), simulation.velocities()[1].y()};
}

Loads pulledBy(double force) {
    Loads loads;
    loads.forces = {{1, {0, force, 0}}};
    return loads;
}

} // namespace

// After the first step, which is one of implicit Euler, z = hλ of both motions grows by (1 + z/2)/(1 − z/2).
TEST(Trapezoid, GrowsByTheAnalyticFactor) {
    for (const double step : {0.001, 0.1, 1.0, 100.0})
        for (const double damping : {0.0, 3.0, 500.0}) {
            SCOPED_TRACE(std::to_string(step) + " s, damping " + std::to_string(damping));
            Simulation simulation(tethered(20, damping), withStep(Integrator::Trapezoid, step));
            ASSERT_TRUE(simulation.step(pulledBy(1e-3)));
            ASSERT_TRUE(simulation.step({})); // the end of the force is a jump
            const Eigen::Matrix2d rates = (Eigen::Matrix2d() << 0, 1, -20, -damping).finished();
            const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
            const Eigen::Matrix2d growth = (one - step / 2 * rates).inverse() * (one + step / 2 * rates);
            for (int i = 0; i < 5; ++i) {
                const Eigen::Vector2d expected = growth * stateOf(simulation);
                ASSERT_TRUE(simulation.step({}));
                const Eigen::Vector2d error = stateOf(simulation) - expected;
                EXPECT_LT(std::abs(error.x()) + step * std::abs(error.y()),
                          1e-9 * (std::abs(expected.x()) + step * std::abs(expected.y())) + 1e-16);
            }
        }
}

TEST(Trapezoid, KeepsTheEnergyOfAnUndampedSwing) {
    for (const double step : {0.01, 1.0}) {
        Simulation simulation(tethered(20, 0), withStep(Integrator::Trapezoid, step));
        for (int i = 0; i < 2; ++i)
            ASSERT_TRUE(simulation.step(i == 0 ? pulledBy(1e-3) : Loads{}));
        const double energy = simulation.energy().total();
        ASSERT_GT(energy, 0);
        for (int i = 0; i < 20'000; ++i)
            ASSERT_TRUE(simulation.step({}));
        EXPECT_NEAR(simulation.energy().total(), energy, 1e-8 * energy);
    }
}

// Without the first step of implicit Euler it would swing about its place by all of the way for ever.
TEST(Trapezoid, DoesNotRingWhereTissueIsStiff) {
    const double stiffness = 1e8, step = 0.01;
    Simulation simulation(tethered(stiffness, 1e8), withStep(Integrator::Trapezoid, step));
    const Loads pull = pulledBy(stiffness * 1e-3);
    for (int i = 1; i <= 100; ++i) {
        const double before = stateOf(simulation).x();
        ASSERT_TRUE(simulation.step(pull));
        EXPECT_GE(stateOf(simulation).x(), before);
        EXPECT_NEAR(stateOf(simulation).x(), 1e-3 * (1 - std::exp(-i * step)), 1e-5);
    }
}

TEST(Trapezoid, LedNodesDoNotRingWhenTheyChangeTheirSpeedALittle) {
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(4, 0.1), {10, 0.05, 0.001});
    Simulation simulation(model, withStep(Integrator::Trapezoid, 1e-3));
    const Eigen::Vector3d rest = model.network->restPositions[15];
    double way = 0;
    for (int i = 0; i < 40; ++i) {
        const double speed = i < 20 ? 0.1 : 0.07;
        way += speed * 1e-3;
        Loads loads;
        loads.prescribed = {{15, rest + Eigen::Vector3d(0, 0, way)}};
        ASSERT_TRUE(simulation.step(loads));
        EXPECT_NEAR(simulation.velocities()[15].z(), speed, 1e-9);
    }
}

// With every step that the equation gives, 24 of these made energy out of nothing.
TEST(Trapezoid, RunsToTheEndAtTheExtremes) {
    const std::vector<ExtremeCase> cases = extremeCases();
    for (std::size_t i = 0; i < cases.size(); i += isSanitized() ? 24 : 1) {
        const ExtremeOutcome outcome = runExtreme(cases[i], Integrator::Trapezoid);
        EXPECT_EQ(outcome.end, ExtremeEnd::Ran) << cases[i].family << ": " << outcome.reason;
    }
}

TEST(Trapezoid, RefusesAxialDamping) {
    SimulationSettings settings = withStep(Integrator::Trapezoid, 1e-3);
    settings.damping = Damping::Axial;
    EXPECT_THROW(Simulation(tethered(20, 1), settings), InvalidModel);
}

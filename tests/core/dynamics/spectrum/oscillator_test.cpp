#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/spectrum/oscillator.h"
#include "tests/support/every_integrator.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

namespace {

/// Whether one node of 1 kg on a tether, stepped by 1 s, moves more after many steps than after few.
bool grows(Integrator integrator, double damping, double stiffness) {
    TissueModel model = tissue::oneSpring({0, 0, 1});
    model.tethers = {{1, stiffness, damping}};
    Simulation simulation(model, withStep(integrator, 1));
    Loads kick;
    kick.forces = {{1, {1e-3, 0, 0}}};
    EXPECT_TRUE(simulation.step(kick));
    double early = 0, late = 0;
    for (int i = 0; i < 20000; ++i) {
        if (!simulation.step({})) return true;
        const double size =
            (simulation.positions()[1] - Eigen::Vector3d(1, 0, 0)).norm() + simulation.velocities()[1].norm();
        double& largest = i < 200 ? early : late;
        if (i < 200 || i > 19000) largest = std::max(largest, size);
        if (size > 0.5) return true;
    }
    return late > early;
}

Growth growthOf(Integrator integrator) {
    return schemeOf(integrator).explicitMethod.growth;
}

/// Those whose bound follows from their growth.
std::vector<Integrator> multistage() {
    return integratorsThat([](Integrator integrator) { return growthOf(integrator) != nullptr; });
}

} // namespace

TEST(Oscillator, GrowsAboveItsLimitAndNotBelow) {
    for (const Integrator integrator : multistage())
        for (const double damping : {0.02, 0.3, 1.0, 1.25}) {
            SCOPED_TRACE(std::string(integratorName(integrator)) + ", damping " + std::to_string(damping));
            const double limit = stiffnessLimit(growthOf(integrator), damping);
            EXPECT_FALSE(grows(integrator, damping, 0.99 * limit)) << limit;
            EXPECT_TRUE(grows(integrator, damping, 1.01 * limit)) << limit;
        }
}

TEST(Oscillator, KnowsTheTextbookLimits) {
    EXPECT_NEAR(stiffnessLimit(growthOf(Integrator::Rk4), 0), 8, 1e-6); // |z| = √8 on the imaginary axis
    EXPECT_LT(stiffnessLimit(growthOf(Integrator::Heun), 0), 1e-3);     // unstable without damping
    EXPECT_NEAR(decayLimit(growthOf(Integrator::Heun)), 2, 1e-9);
    EXPECT_NEAR(decayLimit(growthOf(Integrator::Rk4)), 2.7852935634, 1e-8);
}

TEST(Oscillator, DecaysBelowItsLimitAndNotAbove) {
    for (const Integrator integrator : multistage()) {
        SCOPED_TRACE(integratorName(integrator));
        const double limit = decayLimit(growthOf(integrator));
        EXPECT_LE(growthFactor(growthOf(integrator), {0.99 * limit, 0}), 1 + 1e-12);
        EXPECT_GT(growthFactor(growthOf(integrator), {1.01 * limit, 0}), 1 + 1e-6);
    }
}

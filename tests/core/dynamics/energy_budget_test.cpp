#include "core/dynamics/simulation.h"
#include "tests/support/every_integrator.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

constexpr tissue::Parameters springy{10, 0.02, 0.001};
const Eigen::Vector3d push(0.02, -0.01, 0.03); ///< N
constexpr std::uint32_t pushed = 5;

/// W, what the springs' dampers turn into heat.
double dissipation(const TissueModel& model, const Vectors& velocities) {
    double power = 0;
    for (std::size_t i = 0; i < model.network->springs.size(); ++i) {
        const Spring& spring = model.network->springs[i];
        power += valuesOf(model, i).viscosity *
                 (velocities[spring.first] - velocities[spring.second]).squaredNorm();
    }
    return power;
}

struct Budget {
    double work = 0, heat = 0; ///< J
    Energy energy;

    /// What came from nowhere or went there, relative to the work done.
    double gap() const { return std::abs(work - heat - energy.total()) / work; }
};

/// Of a ball that is pushed for half of 0.2 s and left alone for the other half.
Budget budgetOf(Integrator integrator, const tissue::Parameters& parameters, int steps,
                const std::optional<SpringStiffening>& law = {}) {
    TissueModel model = tissue::fromMesh(tissue::sphereMesh(1, 0.05), parameters);
    model.stiffening = law;
    const double timeStep = 0.2 / steps;
    Simulation simulation(model, withStep(integrator, timeStep));
    Budget budget;
    for (int i = 0; i < steps; ++i) {
        Loads loads;
        if (2 * i < steps) loads.forces = {{pushed, push}};
        const Eigen::Vector3d before = simulation.positions()[pushed];
        const double power = dissipation(model, simulation.velocities());
        EXPECT_TRUE(simulation.step(loads));
        if (2 * i < steps) budget.work += push.dot(simulation.positions()[pushed] - before);
        budget.heat += timeStep / 2 * (power + dissipation(model, simulation.velocities()));
    }
    budget.energy = simulation.energy();
    return budget;
}

class EnergyBudget : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, EnergyBudget, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

// What a force does ends as motion, as stretched springs or as heat: the more exactly, the shorter the steps.
TEST_P(EnergyBudget, IsBalanced) {
    // Its matrix is stiffer than the tissue, which takes motion away as a shorter step would not.
    const int steps = GetParam() == Integrator::Projective ? 6400 : 1600;
    const double coarse = budgetOf(GetParam(), springy, steps / 4).gap();
    const Budget fine = budgetOf(GetParam(), springy, steps);
    EXPECT_GT(fine.heat, 0.1 * fine.work);
    EXPECT_GT(fine.energy.total(), 0.05 * fine.work);
    EXPECT_LT(fine.gap(), 0.02);
    EXPECT_LT(fine.gap(), 0.3 * coarse);
}

TEST_P(EnergyBudget, IsBalancedWhereSpringsBecomeStiffer) {
    const int steps = GetParam() == Integrator::Projective ? 6400 : 1600;
    const Budget fine = budgetOf(GetParam(), springy, steps, SpringStiffening{0.02, 5});
    EXPECT_GT(fine.heat, 0.1 * fine.work);
    EXPECT_LT(fine.gap(), 0.02);
}

TEST_P(EnergyBudget, MakesNoEnergyWithoutDamping) {
    if (GetParam() == Integrator::Heun || GetParam() == Integrator::Split2)
        GTEST_SKIP() << "no step is stable without viscosity";
    const Budget budget = budgetOf(GetParam(), {10, 0, 0.001}, 1600);
    EXPECT_LT(budget.energy.total(), 1.02 * budget.work);
}

} // namespace

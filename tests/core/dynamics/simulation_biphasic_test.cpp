#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using tissue::Vectors;

namespace {

constexpr std::uint32_t lowest = 24;

/// A net of 25 nodes that hangs by its upper edge and is pulled down at a corner.
TissueModel hangingNet(const std::optional<SpringStiffening>& law) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(5, 0.1), {20, 0.05, 0.001});
    model.fixedNodes = {0, 1, 2, 3, 4};
    model.stiffening = law;
    return model;
}

Vectors pulled(Integrator integrator, double timeStep, const std::optional<SpringStiffening>& law) {
    Simulation simulation(hangingNet(law), withStep(integrator, timeStep));
    Loads loads;
    loads.forces = {{lowest, {0.1, 0.4, 0.1}}};
    for (int i = 0; i < std::lround(0.1 / timeStep); ++i)
        EXPECT_TRUE(simulation.step(loads)) << simulation.failure();
    return simulation.positions();
}

/// Relative to how far the reference went.
double difference(const Vectors& reference, const Vectors& other, const TissueModel& model = hangingNet({})) {
    return motionDifference(other, reference, model.network->restPositions);
}

class BiphasicMotion : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, BiphasicMotion, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

TEST_P(BiphasicMotion, FollowsAFineReference) {
    const SpringStiffening law{0.2, 5};
    const Vectors reference = pulled(Integrator::Rk4, 1e-4, law);
    ASSERT_GT(difference(reference, pulled(Integrator::Rk4, 1e-4, {})), 0.1) << "the law is not reached";
    const double coarse = difference(reference, pulled(GetParam(), 4e-4, law));
    const double fine = difference(reference, pulled(GetParam(), 1e-4, law));
    EXPECT_LT(fine, GetParam() == Integrator::Projective ? 0.03 : 0.003);
    EXPECT_LT(fine, 0.3 * coarse);
}

TEST_P(BiphasicMotion, KnowsNothingOfALawBeyondItsReach) {
    const Vectors linear = pulled(GetParam(), 1e-3, {});
    EXPECT_LT(difference(linear, pulled(GetParam(), 1e-3, SpringStiffening{5, 100})), 1e-6);
}

Vectors pulledTube(Integrator integrator, double timeStep) {
    TissueModel tube = tissue::fallopianTube();
    tube.stiffening = SpringStiffening{0.2, 1000};
    Simulation simulation(tube, withStep(integrator, timeStep));
    Loads pull;
    pull.forces = {{85, {0, 0, 10}}};
    for (int i = 0; i < std::lround(0.3 / timeStep); ++i)
        EXPECT_TRUE(simulation.step(pull)) << simulation.failure();
    return simulation.positions();
}

// A whole Newton step passes the strain, where springs become a thousand times as stiff.
TEST(BiphasicTube, IsNotHeldBackByStepsThatOvershoot) {
    if (isSanitized()) GTEST_SKIP() << "more of the same steps show nothing more to the sanitizers";
    const Vectors reference = pulledTube(Integrator::Bdf2, 1e-3);
    for (const Integrator integrator : {Integrator::Implicit, Integrator::Bdf2}) {
        const Vectors coarse = pulledTube(integrator, 5e-3);
        EXPECT_LT(difference(reference, coarse, tissue::fallopianTube()), 0.03);
    }
}

} // namespace

#include "core/dynamics/settings.h"
#include "core/dynamics/stability/stability.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

TEST(SimulationSettings, OnlyExplicitIntegratorsLeaveOutWhatRests) {
    SimulationSettings settings;
    settings.restTolerance = 1e-6;
    const auto computesAll = testing::AnyOf(Integrator::Propagation, Integrator::Implicit, Integrator::Bdf2,
                                            Integrator::Projective, Integrator::Split, Integrator::Split2);
    for (const Integrator integrator : allIntegrators) {
        settings.integrator = integrator;
        EXPECT_EQ(!validate(settings).empty(), testing::Value(integrator, computesAll))
            << integratorName(integrator);
    }
    settings.integrator = Integrator::Auto;
    EXPECT_THAT(validate(settings), testing::IsEmpty());
    EXPECT_EQ(chooseStep(tissue::fallopianTube(), settings).integrator, Integrator::Euler);
    settings.restTolerance = 0;
    EXPECT_NE(chooseStep(tissue::fallopianTube(), settings).integrator, Integrator::Euler);
}

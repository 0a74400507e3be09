#include "core/dynamics/settings.h"
#include "core/dynamics/stability/stability.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;

TEST(SimulationSettings, OnlyExplicitIntegratorsLeaveOutWhatRests) {
    SimulationSettings settings;
    settings.restTolerance = 1e-6;
    for (const Integrator integrator : allIntegrators) {
        settings.integrator = integrator;
        EXPECT_EQ(!validate(settings).empty(), traitsOf(integrator).kind != StepKind::Explicit)
            << integratorName(integrator);
    }
    settings.integrator = Integrator::Auto;
    EXPECT_THAT(validate(settings), testing::IsEmpty());
    EXPECT_EQ(chooseStep(tissue::fallopianTube(), settings).integrator, Integrator::Euler);
    settings.restTolerance = 0;
    EXPECT_NE(chooseStep(tissue::fallopianTube(), settings).integrator, Integrator::Euler);
}

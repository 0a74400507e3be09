#include "core/model/integrators.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(IntegratorTraits, TellIntegratorsApart) {
    for (const Integrator one : allIntegrators) {
        const IntegratorTraits& traits = traitsOf(one);
        SCOPED_TRACE(traits.name);
        EXPECT_EQ(integratorFromName(traits.name), one);
        EXPECT_EQ(std::string(traits.sentence).rfind(std::string(traits.name) + ", ", 0), 0U);
        EXPECT_GT(traits.stepCost, 0);
        for (const Integrator other : allIntegrators)
            EXPECT_EQ(traitsOf(other).colour == traits.colour, one == other);
    }
    EXPECT_EQ(integratorFromName("no such thing"), std::nullopt);
}

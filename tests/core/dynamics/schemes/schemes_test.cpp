#include "core/dynamics/schemes/schemes.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Schemes, HoldWhatTheKindOfTheirStepsNeeds) {
    for (const Integrator integrator : allIntegrators) {
        SCOPED_TRACE(integratorName(integrator));
        const Scheme& scheme = schemeOf(integrator);
        const IntegratorTraits& traits = traitsOf(integrator);
        ASSERT_TRUE(scheme.largestStable && scheme.ownDamping && scheme.factors);
        EXPECT_EQ(scheme.form != nullptr, traits.kind == StepKind::Solving);
        EXPECT_EQ(scheme.explicitMethod.stepInDouble != nullptr, traits.kind == StepKind::Explicit);
        EXPECT_EQ(scheme.explicitMethod.stepInFloat != nullptr, traits.kind == StepKind::Explicit);
        EXPECT_EQ(traitsOf(traits.startsAs).kind, traits.kind);
        EXPECT_EQ(traitsOf(traits.startsAs).startsAs, traits.startsAs);
    }
}

TEST(Schemes, AreOneForEachIntegrator) {
    for (const Integrator one : allIntegrators)
        for (const Integrator other : allIntegrators)
            EXPECT_EQ(&schemeOf(one) == &schemeOf(other), one == other);
}

#include "core/exchange/simulators/sofa/sofa_trial.h"

#include "core/exchange/simulators/sofa/sofa_scene.h"
#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/stand_in_sofa.h"
#include "tests/support/steady_progress.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

SofaTrial trialAs(const std::string& role, const Project& project, const Progress& progress = {}) {
    const test::WithVariable named("SOFA_ROLE", role);
    HandoverMeans means;
    means.progress = progress;
    means.engine.timeStep = 0.001;
    return tryInSofa(test::standInSofa(), project, means);
}

TEST(SofaTrial, FindsNoErrorWhereBothMotionsAreTheSame) {
    const SofaTrial trial = trialAs("right", test::falling(makeSample("tube")));
    EXPECT_LT(trial.error, 3e-4);
    EXPECT_GT(trial.error, 0);
    ASSERT_EQ(trial.times.size(), 21U);
    EXPECT_NEAR(trial.times.back(), 0.1, 1e-12);
    for (std::size_t i = 0; i < trial.times.size(); ++i) {
        const double way = 9.81 / 2 * trial.times[i] * trial.times[i];
        EXPECT_NEAR(trial.here.at(i), way, 2e-4 * test::fallenBy);
        EXPECT_NEAR(trial.there.at(i), way, 1e-4 * test::fallenBy);
    }
    EXPECT_GT(trial.wallHere, 0);
    EXPECT_NEAR(trial.wallThere, 1.5 / 0.101, 1e-9);
}

TEST(SofaTrial, TellsHowFarTheMotionsAreApart) {
    // In twice the time it falls four times as far: three times the motion too far.
    EXPECT_NEAR(trialAs("far", test::falling(makeSample("tube"))).error, 3, 0.01);
}

TEST(SofaTrial, AsksForSomethingThatMovesTheOrgan) {
    Project project = test::falling(makeSample("tube"));
    project.scene.gravity.setZero();
    EXPECT_THROW(trialAs("right", project), InvalidModel);
}

TEST(SofaTrial, TellsHowFarItIsAndStopsAnywhere) {
    test::expectGoodProgress(
        [](const Progress& progress) { trialAs("right", test::falling(makeSample("tube")), progress); });
}

TEST(SofaTrial, LeavesOutWhatSofaIsNotHanded) {
    Scene scene = makeSample("tube").scene;
    scene.forces = {{3, {0, 0, 1}, 0, 1}};
    ASSERT_FALSE(scene.instruments.empty());
    const Scene kept = sceneInSofa(scene);
    EXPECT_TRUE(kept.instruments.empty());
    EXPECT_EQ(kept.forces, scene.forces);
    EXPECT_EQ(kept.fixed, scene.fixed);
}

} // namespace
} // namespace esm

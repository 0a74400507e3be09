#include "core/dynamics/scene_accuracy.h"

#include "core/dynamics/motion_error.h"
#include "core/support/errors.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

struct PulledForAccuracy {
    TissueModel model = tissue::fallopianTube();
    Scene scene;

    PulledForAccuracy() {
        scene.duration = 0.2;
        scene.forces = {{85, {0, 0, 0.1}, 0, 0.1}};
        scene.record.every = 0.05;
    }
    AccurateOutcome run(double mostError, const SimulationSettings& settings, Trajectory& trajectory) const {
        const auto keep = [&](double time, const std::vector<Eigen::Vector3d>& positions) {
            trajectory[std::lround(time / scene.record.every)] = positions;
        };
        const auto newSink = [&]() -> FrameSink {
            trajectory.clear();
            return keep;
        };
        return runSceneToError({model, {}, scene, settings}, mostError, newSink);
    }
};

TEST(SceneAccuracy, ReachesTheErrorThatIsWanted) {
    const PulledForAccuracy tube;
    Trajectory rough, exact;
    const AccurateOutcome outcome = tube.run(0.01, {}, rough);
    EXPECT_LE(outcome.estimatedError, 0.01);
    EXPECT_GT(outcome.estimatedError, 0);
    EXPECT_TRUE(outcome.outcome.stable);
    EXPECT_EQ(rough.size(), 5U);
    const AccurateOutcome finer = tube.run(1e-4, {}, exact);
    EXPECT_LT(finer.outcome.timeStep, outcome.outcome.timeStep);
    EXPECT_LE(relativeError(rough, exact), 0.01);
}

TEST(SceneAccuracy, RefusesWhatRoundingSpoils) {
    Trajectory ignored;
    SimulationSettings settings;
    settings.integrator = Integrator::Verlet;
    settings.timeStep = 2e-6;
    settings.precision = Precision::Float;
    PulledForAccuracy tube;
    tube.scene.duration = tube.scene.record.every = 1e-3;
    EXPECT_THROW(tube.run(1e-12, settings, ignored), InvalidModel);
}

TEST(SceneAccuracy, RefusesStepsThatMeetAtNoRecordedTime) {
    Trajectory ignored;
    SimulationSettings settings;
    settings.integrator = Integrator::Split2;
    settings.timeStep = 0.03;
    PulledForAccuracy tube;
    tube.scene.duration = tube.scene.record.every = 0.1;
    EXPECT_THROW(tube.run(0.5, settings, ignored), InvalidModel);
}

TEST(SceneAccuracy, HandsTheFramesOnAsTheyCome) {
    const PulledForAccuracy tube;
    int begun = 0, received = 0;
    const auto newSink = [&]() -> FrameSink {
        ++begun;
        return [&](double, const std::vector<Eigen::Vector3d>&) { EXPECT_EQ(received++ / 5, begun - 1); };
    };
    SimulationSettings settings;
    settings.timeStep = 0.025;
    const AccurateOutcome outcome = runSceneToError({tube.model, {}, tube.scene, settings}, 0.01, newSink);
    EXPECT_EQ(received, 5 * begun);
    EXPECT_EQ(outcome.outcome.timeStep, std::ldexp(0.025, 1 - begun));
}

TEST(SceneAccuracy, OfWhatStaysAtRestIsWhole) {
    PulledForAccuracy tube;
    tube.scene.forces.clear();
    Trajectory ignored;
    EXPECT_EQ(tube.run(1e-6, {}, ignored).estimatedError, 0);
    EXPECT_EQ(ignored.size(), 5U);
}

TEST(SceneAccuracy, ShortensAStepThatIsTooLong) {
    PulledForAccuracy tube;
    tube.scene.duration = tube.scene.record.every = 1e-3;
    SimulationSettings settings;
    settings.integrator = Integrator::Euler;
    settings.timeStep = 2.5e-5;
    Trajectory ignored;
    const AccurateOutcome outcome = tube.run(0.05, settings, ignored);
    EXPECT_TRUE(outcome.outcome.stable);
    EXPECT_LT(outcome.outcome.timeStep, 1e-5);
}

} // namespace
} // namespace esm

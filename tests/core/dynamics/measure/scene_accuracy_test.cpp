#include "core/dynamics/measure/scene_accuracy.h"

#include "core/dynamics/measure/motion_error.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/reference_motion.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

#include <cmath>

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

TEST(SceneAccuracy, ComparesAtTheEndStepsThatMeetAtNoRecordedTime) {
    Trajectory rough, exact;
    SimulationSettings settings;
    settings.integrator = Integrator::Split2;
    settings.timeStep = 0.03;
    PulledForAccuracy tube;
    tube.scene.duration = tube.scene.record.every = 0.1;
    const AccurateOutcome outcome = tube.run(0.5, settings, rough);
    tube.run(1e-4, {}, exact);
    EXPECT_GT(outcome.estimatedError, 0);
    EXPECT_LE(relativeError(rough, exact), outcome.estimatedError);
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

class SceneAccuracyByEach : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(SceneAccuracy, SceneAccuracyByEach, testing::ValuesIn(allIntegrators),
                         nameOfIntegratorTest);

// 11 N for 0.8 ms on a corner, between two steps of any that is chosen.
TEST_P(SceneAccuracyByEach, ClaimsNoLessThanTheTrueErrorOfABlow) {
    const TriangleMesh tetrahedron{{{0, 0, 0}, {0.05, 0, 0}, {0.025, 0.0433, 0}, {0.025, 0.0144, 0.0408}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    TissueModel model = tissue::fromMesh(tetrahedron, {10, 0.1, 0.0025});
    model.fixedNodes = {0, 1, 2};
    Scene scene;
    scene.duration = 0.2;
    scene.forces = {{3, {3, 0, 11}, 0.0123, 0.0131}};
    SimulationSettings settings;
    settings.integrator = GetParam();
    std::vector<double> times;
    std::vector<std::vector<Eigen::Vector3d>> places;
    const auto newSink = [&]() -> FrameSink {
        times.clear();
        places.clear();
        return [&](double time, const std::vector<Eigen::Vector3d>& positions) {
            times.push_back(time);
            places.push_back(positions);
        };
    };
    const AccurateOutcome outcome = runSceneToError({model, {}, scene, settings}, 0.02, newSink);
    const reference::ExactMotion exact = reference::exactMotion({model, scene}, times);
    const double error = reference::relativeDifference(places, exact.places, model.network->restPositions);
    EXPECT_GT(outcome.estimatedError, 0);
    EXPECT_LE(error, 1.2 * outcome.estimatedError + exact.error);
}

/// A node of 1 g on a tether without viscosity, with a force from the start on: it swings for ever.
struct Swinging {
    TissueModel model;
    Scene scene;

    explicit Swinging(double springConstant) {
        SpringNetwork network;
        network.restPositions = {{0, 0, 0}};
        model = tissue::model(network, {0, 0, 0.001});
        model.tethers = {{0, springConstant, 0}};
        scene.forces = {{0, {1, 0, 0}, 0, 10}};
        scene.record.every = 0.01;
    }
    AccurateOutcome run(Integrator integrator, double timeStep, double mostError) {
        SimulationSettings settings;
        settings.integrator = integrator;
        settings.timeStep = timeStep;
        const auto newSink = [&]() -> FrameSink {
            frames.clear();
            return [this](double time, const std::vector<Eigen::Vector3d>& positions) {
                frames.emplace_back(time, positions.front().x());
            };
        };
        return runSceneToError({model, {}, scene, settings}, mostError, newSink);
    }
    /// Relative to the true motion, F/c·(1 − cos ωt).
    double trueError() const {
        const double c = model.tethers.front().springConstant, frequency = std::sqrt(c / 0.001);
        double difference = 0, motion = 0;
        for (const auto& [time, x] : frames) {
            const double place = (1 - std::cos(frequency * time)) / c;
            difference += std::pow(x - place, 2);
            motion += std::pow(place, 2);
        }
        return std::sqrt(difference / motion);
    }

    std::vector<std::pair<double, double>> frames;
};

TEST(SceneAccuracy, RefusesStepsThatDampSwingsAway) {
    for (const Integrator integrator :
         {Integrator::Implicit, Integrator::Bdf2, Integrator::Projective, Integrator::Propagation}) {
        Swinging node(1000);
        node.scene.duration = 0.2;
        try {
            const AccurateOutcome outcome = node.run(integrator, 0.01, 0.05);
            EXPECT_LE(node.trueError(), 2 * outcome.estimatedError) << integratorName(integrator);
        } catch (const InvalidModel& refused) {
            EXPECT_THAT(refused.what(), testing::HasSubstr("choose verlet"));
        }
    }
}

TEST(SceneAccuracy, GoesOnUntilStepsFollowTheSwings) {
    Swinging node(1000);
    const AccurateOutcome outcome = node.run(Integrator::Bdf2, 0.01, 0.01);
    EXPECT_EQ(outcome.outcome.integrator, Integrator::Bdf2);
    EXPECT_FALSE(outcome.hidesSwings);
    EXPECT_LE(node.trueError(), 1.2 * outcome.estimatedError);
}

TEST(SceneAccuracy, TakesTheSecondOrderThatCostsNextToNothing) {
    TissueModel ball = tissue::fromMesh(tissue::sphereMesh(1, 0.05), {100, 0.001, 0.001});
    ball.fixedNodes = {0, 1, 2};
    Scene scene;
    scene.duration = 0.1;
    scene.forces = {{30, {0, 0, 0.01}, 0, 0.05}};
    scene.record.every = 0.05;
    const AccurateOutcome outcome =
        runSceneToError({ball, {}, scene}, 0.01, [] { return FrameSink([](double, const auto&) {}); });
    EXPECT_EQ(outcome.outcome.integrator, Integrator::Verlet);
}

TEST(SceneAccuracy, SaysWhatItCouldNotFollow) {
    Swinging node(1e18);
    node.scene.duration = 0.1;
    const AccurateOutcome outcome = node.run(Integrator::Implicit, 0.01, 0.01);
    EXPECT_LE(outcome.estimatedError, 0.01);
    EXPECT_TRUE(outcome.hidesSwings);
}

TEST(SceneAccuracy, ShortensExplicitStepsUntilTheyKeepTheSwings) {
    Swinging node(1000);
    node.scene.record.every = 1;
    const AccurateOutcome outcome = node.run(Integrator::Rk4, 0.002, 0.01);
    EXPECT_FALSE(outcome.hidesSwings);
    EXPECT_LE(node.trueError(), 0.01);
}

TEST(SceneAccuracy, TrustsImplicitStepsOfOverdampedTissue) {
    const PulledForAccuracy tube;
    Trajectory rough, exact;
    SimulationSettings settings;
    settings.integrator = Integrator::Implicit;
    settings.timeStep = 0.01;
    const AccurateOutcome outcome = tube.run(0.02, settings, rough);
    EXPECT_EQ(outcome.outcome.integrator, Integrator::Implicit);
    EXPECT_FALSE(outcome.hidesSwings);
    tube.run(1e-4, {}, exact);
    EXPECT_LE(relativeError(rough, exact), 1.5 * outcome.estimatedError);
    EXPECT_GT(relativeError(rough, exact), 0.2 * outcome.estimatedError);
}

TEST(SceneAccuracy, LetsAutoFollowTheSwings) {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(9, 0.1), {3e4, 0, 0.001});
    model.fixedNodes = {0, 8, 72, 80};
    Scene scene;
    scene.duration = 0.1;
    scene.forces = {{40, {1, 0, 0}, 0, 10}};
    SimulationSettings settings;
    settings.timeStep = 0.01; // too long for all that is explicit
    ASSERT_FALSE(isExplicit(runScene({model, {}, scene, settings}, {}).integrator));
    const AccurateOutcome outcome =
        runSceneToError({model, {}, scene, settings}, 0.05, [] { return FrameSink([](double, auto&) {}); });
    EXPECT_EQ(outcome.outcome.integrator, Integrator::Verlet);
    EXPECT_FALSE(outcome.hidesSwings);
}

} // namespace
} // namespace esm

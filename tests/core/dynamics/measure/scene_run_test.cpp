#include "core/dynamics/measure/scene_run.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/recorded_frames.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/tissue_models.h"

#include <gmock/gmock.h>

using namespace esm;
using tissue::Vectors;

namespace {

/// @param side nodes along a side of the grid
TissueModel heldAtOneSide(const TriangleMesh& grid, std::uint32_t side) {
    TissueModel model = tissue::fromMesh(grid, {10, 0.1, 0.001});
    for (std::uint32_t i = 0; i < side; ++i)
        model.fixedNodes.push_back(i);
    return model;
}

TissueModel membrane() {
    TissueModel model = tissue::fromMesh(tissue::gridMesh(7, 0.1), {10, 0.1, 0.001});
    model.fixedNodes = {0, 6, 42, 48};
    return model;
}

TEST(SceneRun, RecordsAtTheFirstStepThatReachesTheTime) {
    Scene scene;
    scene.duration = 0.105;
    scene.record.every = 0.03;
    RecordedFrames frames;
    const SceneOutcome outcome =
        runScene({membrane(), {}, scene, withStep(Integrator::Split, 0.01)}, frames.sink());
    ASSERT_EQ(frames.times.size(), 5);
    EXPECT_THAT(frames.times, testing::Pointwise(testing::DoubleNear(1e-12), {0.0, 0.03, 0.06, 0.09, 0.105}));
    EXPECT_EQ(outcome.steps, 11);
    EXPECT_EQ(outcome.outcome, "completed");
    EXPECT_TRUE(outcome.stable);
    EXPECT_EQ(outcome.simulatedSeconds, 0.105);
}

TEST(SceneRun, DoesNotDriftOverManySteps) {
    Scene scene;
    scene.duration = 1000;
    scene.record.every = 0.1;
    RecordedFrames frames;
    const SceneOutcome outcome =
        runScene({tissue::oneSpring({10, 1, 1}), {}, scene, withStep(Integrator::Split, 0.1)}, frames.sink());
    EXPECT_EQ(outcome.steps, 10000);
    EXPECT_EQ(frames.times.size(), 10001);
    EXPECT_NEAR(frames.times.back(), 1000, 1e-9);
}

TEST(SceneRun, PutsFramesOnStepsWhenItChoosesTheStep) {
    Scene scene;
    scene.duration = 0.5;
    scene.record.every = 0.025;
    RecordedFrames frames;
    const SceneOutcome outcome = runScene({membrane(), {}, scene, {}}, frames.sink());
    EXPECT_LE(outcome.timeStep, 0.01);
    ASSERT_EQ(frames.times.size(), 21);
    for (std::size_t i = 0; i < 21; ++i)
        EXPECT_NEAR(frames.times[i], 0.025 * static_cast<double>(i), 1e-12);
}

TEST(SceneRun, GivesEachFrameOnceWhenStepsAreLonger) {
    Scene scene;
    scene.duration = 0.1;
    scene.record.every = 0.001;
    RecordedFrames frames;
    runScene({membrane(), {}, scene, withStep(Integrator::Split, 0.02)}, frames.sink());
    EXPECT_THAT(frames.times,
                testing::Pointwise(testing::DoubleNear(1e-12), {0.0, 0.02, 0.04, 0.06, 0.08, 0.1}));
}

TEST(SceneRun, RefusesMoreStepsThanCanBeRun) {
    Scene scene;
    scene.duration = 1e25;
    EXPECT_THROW(runScene({membrane(), {}, scene, withStep(Integrator::Split, 0.01)}, {}), InvalidModel);
    EXPECT_THROW(runScene({membrane(), {}, scene}, {}), InvalidModel);
    scene.duration = 1;
    EXPECT_THROW(runScene({membrane(), {}, scene, withStep(Integrator::Split, 1e-300)}, {}), InvalidModel);
    EXPECT_THROW(runScene({membrane(), {}, scene, withStep(Integrator::Split, 5e-324)}, {}), InvalidModel);
    scene.duration = 1e308;
    EXPECT_THROW(runScene({membrane(), {}, scene, withStep(Integrator::Split, 1e-2)}, {}), InvalidModel);
}

TEST(SceneRun, CutsAStepThatIsLongerThanTheScene) {
    Scene scene;
    scene.duration = 1e-9;
    RecordedFrames frames;
    const SceneOutcome outcome = runScene(
        {tissue::oneSpring({10, 1, 1}), {}, scene, withStep(Integrator::Split, 0.01)}, frames.sink());
    EXPECT_EQ(outcome.steps, 1);
    EXPECT_EQ(outcome.timeStep, 0.01);
    EXPECT_EQ(outcome.shortestStep, 1e-9);
    EXPECT_THAT(frames.times, testing::ElementsAre(0, 1e-9));
}

TEST(SceneRun, RecordsStartAndEndWhenFramesAreFartherApartThanTheRunIsLong) {
    Scene scene;
    scene.duration = 0.1;
    for (const double every : {1.0, 1e25, 1e308}) {
        scene.record.every = every;
        for (const SimulationSettings& settings : {withStep(Integrator::Split, 0.01), SimulationSettings()}) {
            RecordedFrames frames;
            const SceneOutcome outcome = runScene({membrane(), {}, scene, settings}, frames.sink());
            EXPECT_EQ(outcome.steps, 10) << every;
            EXPECT_THAT(frames.times, testing::Pointwise(testing::DoubleNear(1e-9), {0.0, 0.1})) << every;
        }
    }
}

TEST(SceneRun, RecordsEveryStepWhenFramesAreCloserThanStepsCanBe) {
    Scene scene;
    scene.duration = 0.05;
    for (const double every : {1e-10, 1e-300}) {
        scene.record.every = every;
        for (const SimulationSettings& settings : {withStep(Integrator::Split, 0.01), SimulationSettings()}) {
            RecordedFrames frames;
            const SceneOutcome outcome = runScene({membrane(), {}, scene, settings}, frames.sink());
            EXPECT_EQ(outcome.timeStep, 0.01) << every;
            EXPECT_EQ(frames.times.size(), 6) << every;
        }
    }
}

TEST(SceneRun, ForcesActFromTheirStartUpToTheirEnd) {
    // A free body: its momentum tells how many steps a force acted in.
    Scene scene;
    scene.duration = 1;
    scene.record.every = 1;
    scene.forces = {{0, {0, 2, 0}, 0.2, 0.5}};
    TissueModel model = tissue::oneSpring({0, 0, 4});
    const SceneOutcome outcome = runScene({model, {}, scene, withStep(Integrator::Euler, 0.1)}, {});
    EXPECT_NEAR(outcome.energy.kinetic, 0.5 * 4 * std::pow(2 * 0.3 / 4, 2), 1e-12);
}

class SceneRunByEach : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(SceneRun, SceneRunByEach, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

// A free body tells how much of a force arrives, and when: it goes on with F·Δt/m from the middle of the
// blow.
TEST_P(SceneRunByEach, LosesNoBlowThatIsShorterThanItsSteps) {
    Scene scene;
    scene.duration = 1;
    scene.record.every = 1;
    scene.forces = {{0, {0, 500, 0}, 0.2313, 0.2321}};
    const TissueModel model = tissue::oneSpring({0, 0, 4});
    // split2 has no stable step without viscosity.
    if (GetParam() == Integrator::Split2) return;
    RecordedFrames frames;
    const SceneOutcome outcome = runScene({model, {}, scene, withStep(GetParam(), 0.1)}, frames.sink());
    const double velocity = 500 * 0.0008 / 4, way = velocity * (1 - 0.2317);
    EXPECT_NEAR(outcome.energy.kinetic, 0.5 * 4 * velocity * velocity, 1e-9);
    const double moved = (frames.positions.back()[0] - frames.positions.front()[0]).y();
    EXPECT_NEAR(moved, way, 0.0005 * velocity);
    EXPECT_EQ(outcome.steps, 12);
    EXPECT_EQ(outcome.cutSteps, 3);
    EXPECT_NEAR(outcome.shortestStep, 0.0008, 1e-12);
    EXPECT_EQ(outcome.averagedCorners, 0);
}

TEST(SceneRun, TakesTheMeanOfLoadsWhereCutsWouldAskForManyFactorisations) {
    Scene scene;
    scene.duration = 1;
    scene.record.every = 1;
    double impulse = 0;
    for (int blow = 0; blow < 20; ++blow) {
        const double from = 0.05 * blow + 0.001 * blow, length = 0.0005 + 0.0001 * blow;
        scene.forces.push_back({0, {0, 100, 0}, from, from + length});
        if (from < 1) impulse += 100 * length;
    }
    const TissueModel model = tissue::oneSpring({0, 0, 4});
    for (const Integrator integrator : {Integrator::Split, Integrator::Bdf2, Integrator::Euler}) {
        const SceneOutcome outcome = runScene({model, {}, scene, withStep(integrator, 0.05)}, {});
        EXPECT_NEAR(outcome.energy.kinetic, 0.5 * impulse * impulse / 4, 1e-9) << integratorName(integrator);
        EXPECT_EQ(outcome.averagedCorners > 0, integrator != Integrator::Euler);
    }
}

TEST(SceneRun, LeadsNodesAlongTheirPaths) {
    Scene scene;
    scene.duration = 1;
    scene.record.every = 0.1;
    scene.record.nodes = std::vector<std::uint32_t>{24, 25};
    scene.moves = {{24, {{0.0, {0, 0, 0}}, {0.5, {0, 0, -0.01}}}}};
    const TissueModel model = membrane();
    RecordedFrames frames;
    runScene({model, {}, scene, {}}, frames.sink());
    const Eigen::Vector3d rest = model.network->restPositions[24];
    ASSERT_EQ(frames.positions.size(), 11);
    ASSERT_EQ(frames.positions[3].size(), 2);
    EXPECT_LT((frames.positions[3][0] - rest - Eigen::Vector3d(0, 0, -0.006)).norm(), 1e-12);
    EXPECT_LT((frames.positions[10][0] - rest - Eigen::Vector3d(0, 0, -0.01)).norm(), 1e-12);
    EXPECT_LT(frames.positions[10][1].z(), -0.001);
}

TEST(SceneRun, PushesTheSurfaceWithItsInstrument) {
    const TriangleMesh mesh = tissue::gridMesh(15, 0.1);
    const TissueModel model = heldAtOneSide(mesh, 15);
    Scene scene;
    scene.instruments = {{Sphere{0.02}, {{0.0, {0, 0, 0.04}}, {0.5, {0, 0, 0.0}}}, {}, {}}};
    RecordedFrames frames;
    EXPECT_TRUE(runScene({model, mesh.triangles, scene, {}}, frames.sink()).touched());
    EXPECT_EQ(frames.positions.front(), model.network->restPositions);
    EXPECT_LE(frames.positions.back()[112].z(), -0.02);
    scene.instruments[0].path = {{0.0, {0, 0, 0.04}}};
    EXPECT_FALSE(runScene({model, mesh.triangles, scene, {}}, {}).touched());
}

TEST(SceneRun, SweepsTheInstrumentFromItsPathsStart) {
    const TriangleMesh mesh = tissue::gridMesh(15, 0.1);
    const TissueModel model = heldAtOneSide(mesh, 15);
    Scene scene;
    scene.duration = 0.02;
    scene.instruments = {{Sphere{0.01}, {{0.0, {0, 0, 0.03}}, {0.005, {0, 0, -0.03}}}, {}, {}}};
    RecordedFrames frames;
    runScene({model, mesh.triangles, scene, withStep(Integrator::Split, 0.01)}, frames.sink());
    EXPECT_LE(frames.positions.back()[112].z(), -0.04 + 1e-9);
}

TEST(SceneRun, DivergingEndsWithItsLastGoodState) {
    Scene scene;
    scene.forces = {{24, {0, 0, 1}, 0, 1}};
    RecordedFrames frames;
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(7, 0.1), {1e6, 0, 1e-4});
    const SceneOutcome outcome =
        runScene({model, {}, scene, withStep(Integrator::Euler, 0.01)}, frames.sink());
    EXPECT_FALSE(outcome.stable);
    EXPECT_NE(outcome.outcome, "completed");
    EXPECT_LT(outcome.simulatedSeconds, 1);
    EXPECT_NEAR(frames.times.back(), outcome.simulatedSeconds, 1e-12);
    for (const Vectors& frame : frames.positions)
        for (const Eigen::Vector3d& position : frame)
            EXPECT_TRUE(position.allFinite());
}

TEST(SceneRun, EndsWithTheFramesItHasAtAStepThatCannotBeComputed) {
    Scene scene;
    scene.duration = 4;
    scene.record.every = 1;
    scene.forces = {{24, {0, 0, 1}, 2, 4}};
    RecordedFrames frames;
    const TissueModel model = tissue::fromMesh(tissue::gridMesh(7, 0.1), {1e6, 1e6, 1e-9});
    const SceneOutcome outcome =
        runScene({model, {}, scene, withStep(Integrator::Propagation, 1)}, frames.sink());
    EXPECT_FALSE(outcome.stable);
    EXPECT_THAT(outcome.outcome, testing::HasSubstr("does not settle"));
    EXPECT_EQ(outcome.steps, 2);
    EXPECT_THAT(frames.times, testing::ElementsAre(0, 1, 2));
}

TEST(SceneRun, IsTheSameEveryTime) {
    const TriangleMesh mesh = tissue::sphereMesh(3, 0.05);
    const TissueModel model = tissue::fromMesh(mesh, {10, 0.1, 0.0001});
    Scene scene;
    scene.duration = 0.5;
    scene.moves = {{7, {{0.0, {0, 0, 0}}, {0.5, {0.01, 0, 0}}}}};
    scene.instruments = {{Sphere{0.02}, {{0.0, {0, 0, 0.08}}, {0.5, {0, 0, 0.04}}}, {}, {}}};
    RecordedFrames first, second;
    runScene({model, mesh.triangles, scene, {}}, first.sink());
    runScene({model, mesh.triangles, scene, {}}, second.sink());
    EXPECT_EQ(first.positions, second.positions);
}

TEST(SceneRun, StopsWhenAsked) {
    Scene scene;
    scene.duration = 1e6;
    const auto stopAfterStart = [](double fraction) { return fraction == 0; };
    EXPECT_THROW(runScene({membrane(), {}, scene, {}}, {}, stopAfterStart), Cancelled);
}

TEST(SceneRun, RefusesASceneForAnotherModel) {
    Scene scene;
    scene.forces = {{900, {0, 0, 1}, 0, 1}};
    scene.moves = {{901, {{0.0, {0, 0, 0}}}}};
    try {
        runScene({membrane(), {}, scene, {}}, {});
        FAIL() << "accepted";
    } catch (const InvalidModel& problem) {
        EXPECT_EQ(problem.problems().size(), 2);
    }
}

} // namespace

#include "core/dynamics/measure/scene_run.h"
#include "core/dynamics/measure/timeline.h"
#include "core/model/scene_cavities.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/filled_ball.h"
#include "tests/support/recorded_frames.h"
#include "tests/support/simulation_settings.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;
using testing::HasSubstr;
using tissue::Vectors;

namespace {

/// A ball as a scene has it filled and pressed.
TissueModel ballIn(const Scene& scene, int levels, const tissue::Parameters& parameters) {
    const TriangleMesh mesh = tissue::sphereMesh(levels, tissue::ballRadius);
    TissueModel model = tissue::fromMesh(mesh, parameters);
    model.cavities = cavitiesOf(scene, *model.network, mesh.triangles);
    return model;
}

/// Blown up within 0.1 s and left to itself.
Scene balloon() {
    Scene scene;
    scene.duration = 0.3;
    scene.record.every = 0.1;
    scene.fillings = {{0, 2000}};
    scene.pressures = {{0, {{0.03, 0}, {0.13, 300}}}};
    return scene;
}

Vectors endOf(const TissueModel& model, const Scene& scene, const SimulationSettings& settings) {
    RecordedFrames frames;
    const SceneOutcome outcome = runScene({model, {}, scene, settings}, frames.sink());
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
    return frames.positions.back();
}

double farthest(const Vectors& a, const Vectors& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

} // namespace

TEST(SceneFluids, AreRecordedWithTheirVolumesAndPressures) {
    const Scene scene = balloon();
    const TissueModel model = ballIn(scene, 2, {30, 0.3, 1e-4});
    RecordedFrames frames;
    const SceneOutcome outcome =
        runScene({model, {}, scene, withStep(Integrator::Split, 1e-3)}, frames.sink());
    ASSERT_EQ(outcome.fluids.size(), frames.times.size());
    const double atRest = tissue::volumeOf(model, model.network->restPositions);
    for (std::size_t i = 0; i < frames.times.size(); ++i) {
        const FluidRow& row = outcome.fluids[i];
        EXPECT_EQ(row.time, frames.times[i]);
        ASSERT_EQ(row.volumes.size(), 1U);
        EXPECT_NEAR(row.volumes[0], tissue::volumeOf(model, frames.positions[i]), 1e-12 * atRest);
        EXPECT_NEAR(row.pressures[0],
                    pressureAt(scene.pressures[0], row.time) + 2000 * (1 - row.volumes[0] / atRest), 1e-6);
    }
    EXPECT_GT(outcome.fluids.back().volumes[0], 1.02 * atRest);
}

TEST(SceneFluids, CutStepsWhereAPressureBeginsEndsOrTurns) {
    Scene scene = balloon();
    scene.pressures = {{0, {{0, 0}, {0.05, 100}, {0.1, 200}, {0.15, 0}, {0.2, 0}, {0.25, 50}}}};
    EXPECT_THAT(pathCorners(scene), testing::ElementsAre(0.1, 0.15, 0.2, 0.25));
}

namespace {

class SceneFluidsOrder : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, SceneFluidsOrder, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

} // namespace

// A rising pressure and a fluid that resists take nothing of an integrator's order.
TEST_P(SceneFluidsOrder, IsThatOfTheIntegrator) {
    const Integrator integrator = GetParam();
    Scene scene = balloon();
    scene.duration = 0.06;
    scene.pressures = {{0, {{0, 0}, {0.1, 300}}}};
    const TissueModel model = ballIn(scene, 0, {30, 0.1, 0.02});
    const Vectors exact = endOf(model, scene, withStep(Integrator::Rk4, 1e-5));
    const double step = 0.01 / std::ceil(orderOf(integrator) < 4 ? 48 : 16);
    const double coarse = farthest(endOf(model, scene, withStep(integrator, step)), exact);
    const double fine = farthest(endOf(model, scene, withStep(integrator, step / 2)), exact);
    EXPECT_GT(coarse, 1e-9 * tissue::ballRadius);
    EXPECT_LT(fine, coarse * std::pow(2, 0.25 - orderOf(integrator)));
}

TEST(SceneFluids, StopTheRunWithWordsWhereTheyBurstTheWall) {
    Scene scene = balloon();
    scene.duration = 30;
    scene.fillings.clear();
    scene.pressures = {{0, {{0, 0}, {30, 3000}}}};
    const TissueModel model = ballIn(scene, 2, {30, 0.3, 1e-4});
    for (const Integrator integrator : {Integrator::Auto, Integrator::Implicit, Integrator::Bdf2}) {
        SimulationSettings settings;
        settings.integrator = integrator;
        RecordedFrames frames;
        const SceneOutcome outcome = runScene({model, {}, scene, settings}, frames.sink());
        EXPECT_FALSE(outcome.stable);
        EXPECT_THAT(outcome.outcome,
                    HasSubstr("the pressure bursts part 1 of the surface (number 0 in files)"));
        // A ball of an even net bears 866 Pa; beyond, it takes a while to give way.
        EXPECT_GT(outcome.simulatedSeconds, 8.5);
        EXPECT_LT(outcome.simulatedSeconds, 12);
        for (const Eigen::Vector3d& position : frames.positions.back())
            ASSERT_TRUE(position.allFinite());
        for (const FluidRow& row : outcome.fluids)
            ASSERT_TRUE(std::isfinite(row.volumes[0]));
    }
}

TEST(SceneFluids, RefuseSplitsThatLetThemRunOut) {
    Scene scene = balloon();
    const TriangleMesh mesh = tissue::sphereMesh(2, tissue::ballRadius);
    const auto& [a, b, c] = mesh.triangles[40];
    scene.splits = {{0.1, {{a, b}, {b, c}}}};
    const TissueModel model = ballIn(scene, 2, {30, 0.3, 1e-4});
    try {
        runScene({model, mesh.triangles, scene, withStep(Integrator::Split, 1e-3)}, {});
        FAIL() << "the split opened a filled part";
    } catch (const InvalidModel& refused) {
        EXPECT_THAT(refused.what(), HasSubstr("split[0]: it opens part 0 of the surface, which is filled"));
    }
}

TEST(SceneFluids, NeedAPartThatTheTissueHasFilled) {
    const Scene scene = balloon();
    const TissueModel dry = tissue::fromMesh(tissue::sphereMesh(1, 0.03), {30, 0.3, 1e-4});
    const SceneOutcome outcome = runScene({dry, {}, scene, withStep(Integrator::Split, 1e-3)}, {});
    EXPECT_FALSE(outcome.stable);
    EXPECT_THAT(outcome.outcome, HasSubstr("not filled"));
}

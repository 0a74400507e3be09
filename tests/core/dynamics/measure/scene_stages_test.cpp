#include "core/dynamics/measure/scene_stages.h"

#include "core/dynamics/measure/scene_accuracy.h"
#include "core/support/errors.h"
#include "tests/support/every_integrator.h"
#include "tests/support/motion_difference.h"
#include "tests/support/recorded_frames.h"
#include "tests/support/sanitized.h"
#include "tests/support/simulation_settings.h"
#include "tests/support/split_tissue.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;
using testing::HasSubstr;
using tissue::pathAlong;
using tissue::Sheet;
using tissue::Vectors;

namespace {

/// Five by five nodes, hung on its lower border.
Sheet hungGrid() {
    Sheet sheet = tissue::sheetOf(tissue::gridMesh(5, 0.1), {40, 0.05, 0.001});
    sheet.tissue.fixedNodes = {0, 1, 2, 3, 4};
    return sheet;
}

/// Pulled apart at its upper corners, split upwards in its middle after 0.02 s.
Scene splittingScene() {
    Scene scene;
    scene.duration = isSanitized() ? 0.03 : 0.1;
    scene.record.every = 0.01;
    scene.forces = {{20, {-0.05, 0, 0.01}, 0, 1}, {24, {0.05, 0, 0.01}, 0, 1}};
    scene.splits = {{0.02, pathAlong({2, 7, 12, 17, 22})}};
    return scene;
}

RecordedFrames framesOf(const Sheet& sheet, const Scene& scene, const SimulationSettings& settings) {
    RecordedFrames frames;
    const TouchedSurface surface(simulatedSurface(*sheet.topology.surface, *sheet.topology.network));
    const SceneOutcome outcome = runScene({sheet.tissue, surface, scene, settings}, frames.sink());
    EXPECT_TRUE(outcome.stable) << outcome.outcome;
    return frames;
}

std::vector<SceneStage> stagesOf(const Sheet& sheet, const Scene& scene) {
    return laterStages(sheet.topology, sheet.tissue, scene);
}

std::string problemOf(const Sheet& sheet, const Scene& scene) {
    try {
        stagesOf(sheet, scene);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return {};
}

TEST(SceneStages, AreNoneWithoutSplits) {
    Scene scene = splittingScene();
    scene.splits.clear();
    EXPECT_THAT(stagesOf(hungGrid(), scene), testing::IsEmpty());
    scene.splits = {{scene.duration, pathAlong({2, 7, 12})}};
    EXPECT_THAT(stagesOf(hungGrid(), scene), testing::IsEmpty()) << "it would happen as the scene ends";
}

TEST(SceneStages, FollowTimeThenTheList) {
    Scene scene = splittingScene();
    scene.splits = {{0.03, pathAlong({10, 11, 12})},
                    {0.02, pathAlong({2, 7, 12, 17, 22})},
                    {0.03, pathAlong({27, 13, 14})}};
    scene.duration = 1;
    const std::vector<SceneStage> stages = stagesOf(hungGrid(), scene);
    ASSERT_EQ(stages.size(), 3U);
    EXPECT_EQ(stages[0].split, 1U);
    EXPECT_EQ(stages[1].split, 0U);
    EXPECT_EQ(stages[2].split, 2U);
    EXPECT_EQ(stages[1].organ.parted.front().twin, 30U);
}

TEST(SceneStages, ShareForcesThatActAndLeadBothParts) {
    Scene scene = splittingScene();
    scene.forces = {{22, {1, 2, 3}, 0, 1}, {22, {4, 0, 0}, 0.05, 1}, {29, {0, 0, 7}, 0, 1}};
    scene.moves = {{12, {{0, {0, 0, 0.01}}}}, {17, {{0, {0, 0, 0.02}}}}, {28, {{0, {0, 0, 0.03}}}}};
    const SceneStage stage = stagesOf(hungGrid(), scene).at(0);
    ASSERT_EQ(stage.organ.parted[4].node, 22U);
    const double share = stage.organ.parted[4].twinShare;
    ASSERT_EQ(stage.scene.forces.size(), 4U);
    EXPECT_LT((stage.scene.forces[0].force - (1 - share) * Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
    EXPECT_EQ(stage.scene.forces[1].force, Eigen::Vector3d(4, 0, 0)) << "begins later: on what it names";
    EXPECT_EQ(stage.scene.forces[3].node, 29U);
    EXPECT_EQ(stage.scene.forces[3].force, share * Eigen::Vector3d(1, 2, 3));
    ASSERT_EQ(stage.scene.moves.size(), 4U) << "28, the twin of 17, has a path of its own";
    EXPECT_EQ(stage.scene.moves[3].node, 27U);
    EXPECT_EQ(stage.scene.moves[3].path, scene.moves[0].path);
}

TEST(SceneStages, NameTheEntryThatIsWrong) {
    Scene scene = splittingScene();
    scene.splits.push_back({0.025, pathAlong({7, 8})});
    EXPECT_THAT(problemOf(hungGrid(), scene), HasSubstr("split[1]: "));
    scene.splits.pop_back();
    scene.splits = {{0.02, pathAlong({6, 12, 18})}};
    scene.forces.push_back({26, {0, 0, 1}, 0, 1});
    EXPECT_THAT(validate(scene, 25), testing::IsEmpty()) << "some path of as many edges might make it";
    EXPECT_THAT(problemOf(hungGrid(), scene),
                AllOf(HasSubstr("forces[2]: there is no node 26"), HasSubstr("the last is 25")));
    scene.forces.back().node = 28;
    EXPECT_THAT(validate(scene, 25), ElementsAre(HasSubstr("forces[2]: there is no node 28")));
    scene.forces.pop_back();
    scene.splits = {{0.02, pathAlong({6, 12, 90, 91, 92})}};
    EXPECT_THAT(validate(scene, 25), ElementsAre(HasSubstr("split[0]: 3 nodes missing (node 90, 91, 92)")));
}

TEST(SceneStages, AreNoMoreThanMemoryHolds) {
    Scene scene = splittingScene();
    scene.forces.clear();
    scene.splits.assign(153'847, scene.splits.front());
    EXPECT_THAT(problemOf(hungGrid(), scene),
                HasSubstr("153847 splits are more than a run of this organ and its loads can hold, 153846"));
}

TEST(SceneStages, RecordWhatIsMadeAfterWhatWasThere) {
    Scene scene;
    scene.record.nodes = {{29, 3, 27, 1}};
    EXPECT_THAT(*recordedNodes(scene, 25), ElementsAre(3, 1, 27, 29));
    scene.record.nodes.reset();
    EXPECT_FALSE(recordedNodes(scene, 25));
}

class SplitScene : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, SplitScene, testing::ValuesIn(allIntegrators), nameOfIntegratorTest);

/// Steps miss the split's time; frames do too.
TEST_P(SplitScene, RecordsNewNodesFromTheFirstTimeAtOrAfterTheSplit) {
    const Sheet sheet = hungGrid();
    Scene scene = splittingScene();
    const RecordedFrames frames = framesOf(sheet, scene, withStep(GetParam(), 0.0007));
    ASSERT_GE(frames.times.size(), 4U);
    for (std::size_t i = 0; i < frames.times.size(); ++i)
        EXPECT_EQ(frames.positions[i].size(), frames.times[i] < 0.02 - 1e-9 ? 25U : 30U) << frames.times[i];
    const Vectors& last = frames.positions.back();
    EXPECT_GT((last[29] - last[22]).norm(), isSanitized() ? 1e-5 : 2e-3);
    scene.record.nodes = {{29, 22}};
    const RecordedFrames chosen = framesOf(sheet, scene, withStep(GetParam(), 0.0007));
    EXPECT_EQ(chosen.positions.front().size(), 1U);
    EXPECT_EQ(chosen.positions.back(), (Vectors{last[22], last[29]}));
}

TEST_P(SplitScene, MovesAsWithOneThread) {
    const Sheet sheet = tissue::sheetOf(tissue::gridMesh(isSanitized() ? 9 : 49, 0.1), {40, 0.05, 1e-5});
    Scene scene;
    scene.duration = 0.01;
    scene.record.every = 0.002;
    scene.gravity = {0.3, 0, -9.81};
    const std::uint32_t side = isSanitized() ? 9 : 49;
    std::vector<std::uint32_t> column;
    for (std::uint32_t row = 0; row < side; ++row)
        column.push_back(row * side + side / 2);
    scene.splits = {{0.0041, pathAlong(column)}};
    SimulationSettings settings = withStep(GetParam(), 0.001);
    settings.timeStep.reset();
    settings.threads = 1;
    const RecordedFrames alone = framesOf(sheet, scene, settings);
    settings.threads = 8;
    const RecordedFrames together = framesOf(sheet, scene, settings),
                         again = framesOf(sheet, scene, settings);
    EXPECT_EQ(alone.positions, together.positions);
    EXPECT_EQ(again.positions, together.positions);
}

/// Of the last frames' nodes that were there from the start, relative to their motion.
double differenceOfLast(const RecordedFrames& frames, const RecordedFrames& reference) {
    return motionDifference(frames.positions.back(), reference.positions.back(), reference.positions.front());
}

TEST(SplitScenes, ReachAWantedError) {
    const Sheet sheet = hungGrid();
    const Scene scene = splittingScene();
    const TouchedSurface surface(simulatedSurface(*sheet.topology.surface, *sheet.topology.network));
    const SceneRun run{sheet.tissue, surface, scene, withStep(Integrator::Split2, 0.002)};
    RecordedFrames found;
    const auto newSink = [&] {
        found = {};
        return found.sink();
    };
    EXPECT_TRUE(runSceneToError(run, 0.02, newSink).isReached);
    const RecordedFrames exact = framesOf(sheet, scene, withStep(Integrator::Verlet, 2e-5));
    EXPECT_LT(differenceOfLast(found, exact), 0.02);
}

/// Where the split lies in a step does not matter: the step is cut there.
TEST(SplitScenes, AreSplitAtTheirTime) {
    const Sheet sheet = hungGrid();
    Scene scene = splittingScene();
    scene.splits[0].time = 0.0217;
    for (const Integrator integrator : {Integrator::Verlet, Integrator::Rk4, Integrator::Split2}) {
        const RecordedFrames coarse = framesOf(sheet, scene, withStep(integrator, 1e-3)),
                             fine = framesOf(sheet, scene, withStep(integrator, 5e-5));
        EXPECT_LT(differenceOfLast(coarse, fine), 0.01) << integratorName(integrator);
    }
}

} // namespace

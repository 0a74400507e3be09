#include "app/editor/workers/pulled_scene.h"

#include "core/dynamics/measure/scene_run.h"
#include "core/model/scene_events.h"
#include "tests/app/editor/workers/poked_organ.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace esm;

namespace {

class PulledScene : public testing::Test {
protected:
    const Project project = pokedOrgan();
    const TissueModel tissue = evaluateModel(project);
    const RecordedRun recorded{project};
    std::optional<Scene> scene = sceneOfPull(recorded.recorder.poke(), project, tissue);
};

} // namespace

TEST_F(PulledScene, LeadsWhatTheHandHeldUntilItLetGo) {
    ASSERT_TRUE(scene);
    // Each end of the pull is noted with the frame that follows; one that comes late makes up for two.
    EXPECT_NEAR(scene->duration, 0.4, 2.0 / 60 + 0.02);
    EXPECT_EQ(scene->tethers, project.scene.tethers);
    EXPECT_TRUE(validate(*scene, project.network->restPositions.size()).empty());
    ASSERT_EQ(scene->moves.front().node, 40U);
    const Path& path = scene->moves.front().path;
    EXPECT_TRUE(path.front().value.isZero());
    EXPECT_LT((path.back().value - Eigen::Vector3d(0.01, 0.02, 0)).norm(), 0.002);
}

TEST_F(PulledScene, MovesTheOrganAsTheHandDid) {
    ASSERT_TRUE(scene);
    scene->record.every = scene->duration;
    const Poke& poke = recorded.recorder.poke();
    const double taken = poke.moments.at(1).time;
    PreviewRun watched;
    ASSERT_TRUE(watched.take(prepareProject(project)));
    ASSERT_TRUE(watched.follow(poke, taken + scene->duration));
    std::vector<Eigen::Vector3d> end;
    runScene({tissue, {}, *scene}, [&](double, const auto& positions) { end = positions; });
    const auto& rest = project.network->restPositions;
    double most = 0, apart = 0;
    const std::vector<Eigen::Vector3d>& seen = watched.positions();
    for (std::size_t node = 0; node < rest.size(); ++node) {
        most = std::max(most, (seen[node] - rest[node]).norm());
        apart = std::max(apart, (seen[node] - end[node]).norm());
    }
    EXPECT_GT(most, 0.01);
    EXPECT_LT(apart, 0.1 * most);
}

TEST_F(PulledScene, TakesThePlaceOfWhatHappenedAndLeavesWhatLasts) {
    Project busy = project;
    busy.scene = withoutEvents(busy.scene);
    busy.scene.gravity = {0, 0, -9.81};
    busy.scene.fillings = {{0, 1000}};
    busy.scene.pressures = {{0, {{0, 500}}}};
    const Scene lasting = busy.scene;
    busy.scene.forces.push_back({3, {0, 0, 1}, 0, 1});
    busy.scene.splits.push_back({});
    busy.scene.record.nodes = {{1000000}}; // as a split would make
    scene = sceneOfPull(recorded.recorder.poke(), busy, tissue);
    ASSERT_TRUE(scene);
    EXPECT_FALSE(scene->moves.empty());
    scene->moves.clear();
    scene->duration = lasting.duration;
    EXPECT_EQ(*scene, lasting);
}

TEST_F(PulledScene, IsOfTheFirstPullThatLasts) {
    Poke poke = recorded.recorder.poke();
    poke.moments.insert(poke.moments.begin() + 1, {0.05, {}});
    poke.moments[0].loads.pull = Pull{7, {0, 0, 0}};
    EXPECT_TRUE(hasPull(poke));
    EXPECT_EQ(sceneOfPull(poke, project, tissue), scene);
}

TEST_F(PulledScene, LeadsNoNodeThatIsFixed) {
    TissueModel held = tissue;
    held.fixedNodes = {40};
    const auto others = sceneOfPull(recorded.recorder.poke(), project, held);
    ASSERT_TRUE(others);
    EXPECT_EQ(others->moves.size() + 1, scene->moves.size());
    held.fixedNodes.resize(project.network->restPositions.size());
    std::iota(held.fixedNodes.begin(), held.fixedNodes.end(), 0U);
    EXPECT_FALSE(sceneOfPull(recorded.recorder.poke(), project, held));
}

TEST_F(PulledScene, IsNoneWithoutAPull) {
    Poke poke = recorded.recorder.poke();
    EXPECT_TRUE(hasPull(poke));
    for (HandMoment& moment : poke.moments)
        moment.loads.pull.reset();
    EXPECT_FALSE(hasPull(poke));
    EXPECT_FALSE(sceneOfPull(poke, project, tissue));
}

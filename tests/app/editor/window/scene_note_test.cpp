#include "app/editor/window/scene_note.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

bool explains(const Scene& scene, const char* words) {
    return sceneNote(scene).explanation.contains(QString::fromUtf8(words));
}

} // namespace

TEST(SceneNote, SaysNothingWhereNothingHappens) {
    Scene scene;
    scene.fixed.push_back({});
    EXPECT_TRUE(sceneNote(scene).title.isEmpty());
    EXPECT_TRUE(sceneNote(scene).explanation.isEmpty());
}

TEST(SceneNote, NamesAllThatHappensAtSetTimes) {
    Scene scene;
    scene.forces.push_back({});
    EXPECT_EQ(sceneNote(scene).title, "Has a scene to play");
    EXPECT_TRUE(explains(scene, "forces act on nodes"));
    EXPECT_FALSE(explains(scene, "nodes are moved"));
    scene.moves.push_back({});
    EXPECT_TRUE(explains(scene, "nodes are moved"));
    scene.instruments.push_back({});
    EXPECT_TRUE(explains(scene, "An instrument follows a path"));
    scene.instruments.push_back({});
    EXPECT_TRUE(explains(scene, "2 instruments follow paths"));
    EXPECT_TRUE(explains(scene, "{playScene}"));
}

TEST(SceneNote, TellsOfPressuresThatChangeAndNotOfThoseThatStand) {
    Scene scene;
    scene.pressures = {{0, {{0, 1000}}}};
    EXPECT_TRUE(sceneNote(scene).title.isEmpty());
    scene.pressures.push_back({1, {{0, 0}, {1, 1000}}});
    EXPECT_TRUE(explains(scene, "pressures from within change"));
}

TEST(SceneNote, DoesNotPromiseToPlaySplits) {
    Scene scene;
    scene.splits.push_back({});
    EXPECT_EQ(sceneNote(scene).title, "Has a scene with splits");
    EXPECT_TRUE(explains(scene, "does not play splits"));
    EXPECT_FALSE(explains(scene, "{playScene}"));
}

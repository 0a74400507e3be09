#include "core/dynamics/measure/scene_loads.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

double forceDuring(double from, double to, double start, double end) {
    Scene scene;
    scene.forces = {{0, {8, 0, 0}, from, to}};
    const Loads loads = loadsDuring(scene, {{0, 0, 0}}, start, end);
    return loads.forces.empty() ? 0 : loads.forces.front().second.x();
}

TEST(SceneLoads, TakeTheMeanOfAForceOverTheStep) {
    EXPECT_EQ(forceDuring(0, 1, 0.25, 0.5), 8);
    EXPECT_EQ(forceDuring(0, 1, 1, 2), 0);
    EXPECT_EQ(forceDuring(1.5, 4, 1, 2), 4);
    EXPECT_EQ(forceDuring(0, 1.25, 1, 2), 2);
    EXPECT_DOUBLE_EQ(forceDuring(1.25, 1.3125, 1, 2), 0.5);
}

TEST(SceneLoads, HaveNothingOfALongForceThatRoundingLeftInAStep) {
    EXPECT_EQ(forceDuring(0.3, 1, 0.2, 0.1 * 3), 0);
    EXPECT_EQ(forceDuring(0.3, 1, 0.3 - 1e-12, 0.4), 8);
    EXPECT_GT(forceDuring(0.3, 0.3 + 1e-12, 0.2, 0.4), 0); // all that there is of it
}

TEST(SceneLoads, LeadToWhereTheStepEnds) {
    Scene scene;
    scene.moves = {{0, {{0, {0, 0, 0}}, {1, {0, 4, 0}}}}};
    scene.instruments = {{Sphere{0.5}, {{0, {1, 0, 0}}, {2, {3, 0, 0}}}, {}, {}}};
    const Loads loads = loadsDuring(scene, {{7, 0, 0}}, 0.25, 0.5);
    EXPECT_EQ(loads.prescribed.front().position, Eigen::Vector3d(7, 2, 0));
    EXPECT_EQ(loads.instruments[0].pose.place, Eigen::Vector3d(1.5, 0, 0));
}

} // namespace
} // namespace esm

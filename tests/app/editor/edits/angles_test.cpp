#include "app/editor/edits/angles.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Angles, ComeBackAsTheyWereTyped) {
    for (const double x : {-170.0, -35.0, 0.0, 12.0, 145.0})
        for (const double y : {-80.0, -8.0, 0.0, 60.0})
            for (const double z : {-179.0, 0.0, 3.0, 90.0}) {
                const Eigen::Vector3d typed(x, y, z);
                EXPECT_LT((degreesOf(rotationOf(typed)) - typed).norm(), 1e-9) << typed.transpose();
            }
}

TEST(Angles, GiveTheSameRotationWhereTheyAreNotUnique) {
    for (const double y : {-90.0, 90.0}) {
        const Eigen::Matrix3d rotation = rotationOf({20, y, 50});
        EXPECT_LT((rotationOf(degreesOf(rotation)) - rotation).norm(), 1e-7);
    }
}

TEST(Angles, TurnAboutOneAxisByTheRightHand) {
    EXPECT_LT((rotationOf({90, 0, 0}) * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    EXPECT_LT((rotationOf({0, 90, 0}) * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
    EXPECT_LT((rotationOf({0, 0, 90}) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

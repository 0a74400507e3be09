#include "core/geometry/pose.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Pose, EqualsAnotherWhoseNumbersAreTheSame) {
    const Pose pose =
        Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
    Pose other = pose;
    EXPECT_TRUE(pose == other);
    other.translation().z() += 1e-15;
    EXPECT_FALSE(pose == other);
    EXPECT_FALSE(pose == Pose::Identity());
}

#include "core/geometry/ellipsoid.h"

#include <gtest/gtest.h>

using esm::contains;
using esm::Ellipsoid;

TEST(Ellipsoid, HoldsPointsUpToItsRadii) {
    Ellipsoid ellipsoid;
    ellipsoid.centre = {1, 2, 3};
    ellipsoid.radii = {0.5, 1, 2};
    EXPECT_TRUE(contains(ellipsoid, {1.5, 2, 3}));
    EXPECT_FALSE(contains(ellipsoid, {1.51, 2, 3}));
    EXPECT_TRUE(contains(ellipsoid, {1, 2, 4.99}));
    EXPECT_FALSE(contains(ellipsoid, {1, 3.01, 3}));
}

TEST(Ellipsoid, TurnsItsAxes) {
    Ellipsoid ellipsoid;
    ellipsoid.radii = {0.1, 1, 1};
    ellipsoid.orientation = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(contains(ellipsoid, {0.9, 0, 0}));
    EXPECT_FALSE(contains(ellipsoid, {0, 0.9, 0}));
}

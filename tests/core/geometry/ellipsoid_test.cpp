#include "core/geometry/ellipsoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

namespace {

/// A place `distance` along the outward normal from the surface's point under a direction of the unit sphere.
Eigen::Vector3d above(const Ellipsoid& ellipsoid, const Eigen::Vector3d& direction, double distance) {
    const Eigen::Vector3d unit = direction.normalized();
    const Eigen::Vector3d normal = unit.cwiseQuotient(ellipsoid.radii).normalized();
    return ellipsoid.centre +
           ellipsoid.orientation * (ellipsoid.radii.cwiseProduct(unit) + distance * normal);
}

std::vector<Eigen::Vector3d> directions() {
    std::vector<Eigen::Vector3d> all;
    for (const double x : {-1.0, -0.3, 0.0, 0.01, 0.8})
        for (const double y : {-0.7, 0.0, 1e-9, 1.0})
            for (const double z : {-1.0, 0.0, 0.2})
                if (x != 0 || y != 0 || z != 0) all.emplace_back(x, y, z);
    return all;
}

} // namespace

TEST(Ellipsoid, TellsTheDistanceToItsSurfaceFromOutside) {
    Ellipsoid ellipsoid;
    ellipsoid.centre = {0.1, -0.2, 0.3};
    ellipsoid.orientation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
    for (const Eigen::Vector3d& radii :
         {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.02, 0.05, 0.03), Eigen::Vector3d(1, 1, 1e-9),
          Eigen::Vector3d(1e-9, 1, 1e-9), Eigen::Vector3d(1e-12, 1e-12, 1e-12), Eigen::Vector3d(30, 1, 1e-4)})
        for (const Eigen::Vector3d& direction : directions())
            for (const double distance : {1e-6, 0.004, 0.5, 40.0}) {
                ellipsoid.radii = radii;
                const double size = 1 + radii.maxCoeff() + distance;
                EXPECT_NEAR(distanceOutside(ellipsoid, above(ellipsoid, direction, distance)), distance,
                            1e-14 * size)
                    << radii.transpose() << " towards " << direction.transpose();
            }
}

TEST(Ellipsoid, IsNoDistanceFromWhatItHolds) {
    Ellipsoid ellipsoid;
    ellipsoid.radii = {0.5, 1, 2};
    EXPECT_EQ(distanceOutside(ellipsoid, {0, 0, 0}), 0);
    EXPECT_EQ(distanceOutside(ellipsoid, {0, 1, 0}), 0);
    EXPECT_EQ(distanceOutside(ellipsoid, {0.1, 0.1, 1.9}), 0);
    ellipsoid.radii.setConstant(1e-300);
    EXPECT_EQ(distanceOutside(ellipsoid, {0, 0, 0}), 0);
    EXPECT_DOUBLE_EQ(distanceOutside(ellipsoid, {0, 3, 4}), 5);
}

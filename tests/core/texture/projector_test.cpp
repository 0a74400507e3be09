#include "core/texture/projector.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Projector, MapsThePhotosCornersFromTheTopLeft) {
    Projector projector;
    projector.width = 0.4;
    projector.height = 0.2;
    EXPECT_TRUE(project(projector, {-0.2, 0.1, 0}).isApprox(Eigen::Vector3d(0, 0, 0)));
    EXPECT_TRUE(project(projector, {0.2, -0.1, -3}).isApprox(Eigen::Vector3d(1, 1, 3)));
    EXPECT_LT(project(projector, {0, 0, 1}).z(), 0) << "behind the photo";
}

TEST(Projector, LooksFromItsPose) {
    Projector projector; // at x = 2 m, looking along −x with y up
    projector.pose = Eigen::Translation3d(2, 0, 0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY());
    const Eigen::Vector3d place = project(projector, {0.5, 0.05, -0.05});
    EXPECT_TRUE(place.isApprox(Eigen::Vector3d(1, 0, 1.5))) << place.transpose();
}

#include "core/texture/projection/projector.h"

#include <gtest/gtest.h>

#include <limits>

using namespace esm;
using Eigen::Vector3d;

namespace {

constexpr PhotoSize photo{400, 200};

Projector perspective() {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.fieldOfView = 90;
    return projector;
}

} // namespace

TEST(Projector, MapsThePhotosCornersFromTheTopLeft) {
    Projector projector;
    projector.width = 0.4;
    projector.height = 0.2;
    EXPECT_TRUE(project(projector, photo, {-0.2, 0.1, 0})->isApprox(Vector3d(0, 0, 0)));
    EXPECT_TRUE(project(projector, photo, {0.2, -0.1, -3})->isApprox(Vector3d(400, 200, 3)));
    EXPECT_LT(project(projector, photo, {0, 0, 1})->z(), 0) << "behind the photo";
}

TEST(Projector, LooksFromItsPose) {
    Projector projector; // at x = 2 m, looking along −x with y up
    projector.pose = Eigen::Translation3d(2, 0, 0) * Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY());
    const Vector3d place = *project(projector, photo, {0.5, 0.05, -0.05});
    EXPECT_TRUE(place.isApprox(Vector3d(400, 0, 1.5))) << place.transpose();
}

TEST(Projector, InPerspectiveSeesItsVerticalFieldOfView) {
    EXPECT_TRUE(project(perspective(), photo, {0, 0, -5})->isApprox(Vector3d(200, 100, 5)));
    EXPECT_TRUE(project(perspective(), photo, {-4, 2, -2})->isApprox(Vector3d(0, 0, 2))) << "top left";
    EXPECT_TRUE(project(perspective(), photo, {8, -4, -4})->isApprox(Vector3d(400, 200, 4)));
}

TEST(Projector, InPerspectiveFollowsIntrinsicsInPlaceOfTheFieldOfView) {
    Projector projector = perspective();
    projector.intrinsics = Intrinsics{300, 250, 190, 110};
    EXPECT_TRUE(project(projector, photo, {0.1, 0.2, -1})->isApprox(Vector3d(220, 60, 1)));
}

TEST(Projector, SeesNothingBehindTheEye) {
    for (const Vector3d& point : {Vector3d(0, 0, 1), Vector3d(0, 0, 0), Vector3d(1, 0, 0),
                                  Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()).eval()})
        EXPECT_FALSE(project(perspective(), photo, point)) << point.transpose();
}

TEST(Projector, WeighsSurfaceLessTheMoreItSlants) {
    const auto weight = [](double degrees) { return angleWeight(std::cos(degrees * M_PI / 180)); };
    EXPECT_EQ(weight(0), 1);
    EXPECT_EQ(weight(59.9), 1);
    EXPECT_NEAR(weight(72.5), 0.5, 1e-9);
    EXPECT_EQ(weight(85.1), 0);
    EXPECT_EQ(weight(90), 0);
    EXPECT_EQ(weight(180), 1) << "from either side";
    EXPECT_EQ(angleWeight(std::numeric_limits<double>::quiet_NaN()), 0);
}

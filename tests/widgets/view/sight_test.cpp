#include "widgets/view/sight.h"

#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// A ball of 1 m, seen from 5 m before it and a little above in a picture of 600 × 450 pixels.
class SightTest : public testing::Test {
protected:
    SightTest() {
        scene.mesh = std::make_shared<TriangleMesh>(ball(48, 72));
        scene.network = edgeNetwork(*scene.mesh);
        camera.eye = {0.37, 1.1, 5}; // through no edge exactly
        camera.verticalFieldOfView = 0.7;
    }
    Vector3d towardsEye() const { return (camera.eye - camera.target).normalized(); }

    RenderScene scene;
    Camera camera;
    Picker picker;
    Sight sight{scene, camera, {600, 450}, picker};
};

} // namespace

TEST_F(SightTest, TheSurfaceHidesWhatLiesBehindIt) {
    EXPECT_TRUE(sight.hides(-1.5 * towardsEye()));
    EXPECT_TRUE(sight.hides(Vector3d::Zero())) << "what lies inside";
    EXPECT_FALSE(sight.hides(1.5 * towardsEye())) << "before it";
    EXPECT_FALSE(sight.hides({2, 0, -1})) << "beside it";
}

TEST_F(SightTest, TheSurfaceDoesNotHideItsOwnPoints) {
    int before = 0, behind = 0;
    for (const Vector3d& vertex : scene.mesh->vertices) {
        const double height = vertex.normalized().dot((camera.eye - vertex).normalized());
        if (std::abs(height) < 0.1) continue; // at the outline
        EXPECT_EQ(sight.hides(vertex), height < 0) << vertex.transpose();
        ++(height > 0 ? before : behind);
    }
    EXPECT_GT(before, 500);
    EXPECT_GT(behind, 500);
}

TEST_F(SightTest, APixelIsWhatLiesBetweenTwoNeighbours) {
    const Vector3d up = cameraAxes(camera).col(1), right = cameraAxes(camera).col(0);
    for (const Vector3d& point : {Vector3d(0, 0, 0), Vector3d(0.8, -0.5, 1), Vector3d(-1, 0.4, -30)}) {
        const double pixel = sight.pixelAt(point);
        for (const Vector3d& way : {up, right}) {
            const auto from = sight.placeOf(point), to = sight.placeOf(point + pixel * way);
            ASSERT_TRUE(from && to);
            EXPECT_NEAR(distance(*from, *to), 1, 1e-6);
        }
    }
}

TEST_F(SightTest, ARayGoesThroughWhatIsSeenAtItsPlace) {
    const Vector3d point(0.3, -0.2, 0.4);
    const Ray ray = sight.rayAt(sight.placeOf(point).value());
    EXPECT_NEAR((point - ray.origin).cross(ray.direction).norm(), 0, 1e-9);
    const Vector3d behindTheEye = camera.eye + towardsEye();
    EXPECT_FALSE(sight.placeOf(behindTheEye));
    EXPECT_EQ(sight.placesOf({point, behindTheEye, Vector3d::Zero()}).size(), 2);
}

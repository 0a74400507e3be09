#include "widgets/view/approach.h"

#include "tests/core/render/subjects.h"
#include "tests/support/rounds.h"
#include "widgets/view/within.h"

#include <gtest/gtest.h>

#include <random>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// A ball of 1 m.
class ApproachTest : public testing::Test {
protected:
    ApproachTest() { take(ball(48, 72)); }
    void take(TriangleMesh mesh) {
        scene.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
        scene.network = edgeNetwork(*scene.mesh);
        picker.sceneChanged();
    }
    Sight sight() { return {scene, camera, {600, 450}, picker}; }

    RenderScene scene;
    Camera camera;
    Picker picker;
};

double turned(std::mt19937& random, double most) {
    return std::uniform_real_distribution(-most, most)(random);
}

} // namespace

TEST_F(ApproachTest, NeverPassesTheSurfaceOfABallFromAnyStart) {
    for (int round = 0; round < 200; ++round) {
        std::mt19937 random(static_cast<unsigned>(round));
        const bool isInside = round % 2;
        const Vector3d direction =
            Vector3d(turned(random, 1), turned(random, 1), turned(random, 1)).normalized();
        camera = Camera();
        camera.eye =
            (isInside ? 0.9 * std::abs(turned(random, 1)) : 1.05 + std::abs(turned(random, 4))) * direction;
        camera.target = 1.5 * Vector3d(turned(random, 1), turned(random, 1), turned(random, 1));
        for (int notch = 0; notch < 60; ++notch) {
            const QPointF place(300 + turned(random, 300), 225 + turned(random, 225));
            camera = approached(sight(), place, std::pow(0.87, turned(random, 4) + (round % 3 - 1)));
            ASSERT_EQ(camera.eye.norm() < 0.999, isInside) << "round " << round;
            ASSERT_GT(picker.clearance(scene, camera.eye).value(), 0.003);
        }
    }
}

TEST_F(ApproachTest, ComesCloseToWhatIsUnderTheMouseAndStops) {
    camera.eye = {0, 0, 5};
    const QPointF place(340, 190);
    const Vector3d point = sight().pickAt(place)->point;
    for (int notch = 0; notch < 200; ++notch)
        camera = approached(sight(), place, 0.8);
    EXPECT_NEAR((camera.eye - point).norm(), 0.004 * 2 * std::sqrt(3.0), 0.001);
    EXPECT_LT(distance(*sight().placeOf(point), place), 0.01);
}

TEST_F(ApproachTest, WithoutPerspectiveTheSameIsUnderTheMouse) {
    camera.eye = {1, 2, 5};
    camera = standingBefore(orthographic(camera), boundingBox(scene.mesh->vertices));
    const QPointF place(300, 210);
    const auto picked = sight().pickAt(place);
    ASSERT_TRUE(picked);
    // Independently: the ball's nearer point on the line through the place.
    const Eigen::Matrix3d axes = cameraAxes(camera);
    const double pixel = *camera.orthographicHeight / 450;
    const Vector3d aside =
        camera.target - camera.target.dot(axes.col(2)) * axes.col(2) + 15 * pixel * axes.col(1);
    const Vector3d expected = aside + std::sqrt(1 - aside.squaredNorm()) * axes.col(2);
    EXPECT_LT((picked->point - expected).norm(), 0.005);
    const double height = *camera.orthographicHeight;
    camera = approached(sight(), place, 0.5);
    EXPECT_NEAR(*camera.orthographicHeight, height / 2, 1e-12);
    EXPECT_LT(distance(*sight().placeOf(picked->point), place), 1e-6);
    EXPECT_FALSE(sight().hides(1.001 * expected));
    EXPECT_TRUE(sight().hides(-expected));
}

TEST_F(ApproachTest, LooksFromTheMiddleOfTheBall) {
    camera.eye = {0.1, 0.2, 5};
    const auto within = cameraWithin(sight(), std::nullopt);
    ASSERT_TRUE(within);
    EXPECT_LT(within->eye.norm(), 0.01);
    EXPECT_TRUE(cameraAxes(*within).isApprox(cameraAxes(camera), 1e-9)) << "the way it looked";
    camera = *within;
    EXPECT_NEAR(sight().pickAt({300, 225})->point.norm(), 1, 0.01) << "picks from inside";
    const auto aside = cameraWithin(sight(), Vector3d(0.5, 0.5, -0.2));
    EXPECT_FALSE(aside) << "one wall alone lies before an eye inside";
}

TEST_F(ApproachTest, LooksAlongATubeAndNotAtItsWall) {
    TriangleMesh tube = ball(48, 72);
    for (Vector3d& vertex : tube.vertices)
        vertex.x() *= 8;
    take(std::move(tube));
    camera.eye = {0.1, 0.2, 30};
    const auto within = cameraWithin(sight(), std::nullopt);
    ASSERT_TRUE(within);
    EXPECT_GT(std::abs(cameraAxes(*within).col(2).x()), 0.9);
}

TEST_F(ApproachTest, PrefersTheCavityToTheWallsAroundIt) {
    TriangleMesh hollow = ball(48, 72);
    const auto count = static_cast<std::uint32_t>(hollow.vertices.size());
    for (std::uint32_t i = 0; i < count; ++i)
        hollow.vertices.push_back(0.8 * hollow.vertices[i]);
    for (const Triangle& triangle : std::vector<Triangle>(hollow.triangles))
        hollow.triangles.push_back({triangle[0] + count, triangle[2] + count, triangle[1] + count});
    take(std::move(hollow));
    camera.eye = {0, 0.3, 5};
    EXPECT_LT(cameraWithin(sight(), std::nullopt)->eye.norm(), 0.3);
}

TEST_F(ApproachTest, FindsNoRoomInAnOpenSheet) {
    TriangleMesh sheet;
    sheet.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    sheet.triangles = {{0, 1, 2}};
    take(std::move(sheet));
    camera.eye = {0, 0, 5};
    EXPECT_FALSE(cameraWithin(sight(), std::nullopt));
}

TEST_F(ApproachTest, GoesOutOfTheSurfaceAroundIt) {
    camera.eye = {0.1, 0, 0.5};
    camera.target = {0.1, 0, 0};
    const Camera outside = outOfSurface(sight());
    EXPECT_GT(outside.eye.norm(), 1);
    EXPECT_LT(outside.eye.norm(), 1.05);
    EXPECT_TRUE(cameraAxes(outside).isApprox(cameraAxes(camera)));
}

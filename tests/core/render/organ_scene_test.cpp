#include "core/render/organ_scene.h"

#include "core/support/angles.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;

namespace {

RenderScene bareBall() {
    const auto mesh = std::make_shared<TriangleMesh>(ball(8, 12));
    return organScene(mesh, edgeNetwork(*mesh), {200, 40, 40});
}

} // namespace

TEST(OrganScene, ShowsSpringsByThemselvesWhereThereIsNothingElse) {
    EXPECT_FALSE(bareBall().showSprings);
    const auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = {{0, 0, 0}, {0.1, 0, 0}};
    EXPECT_TRUE(organScene(mesh, edgeNetwork(*mesh), {0, 0, 0}).showSprings);
}

TEST(OrganScene, TellsWhetherAPhotoIsLaid) {
    RenderScene scene = bareBall();
    TextureLayer layer;
    EXPECT_FALSE(drawnProjector(scene, layer, true).isLaid);
    scene.texturePages = std::make_shared<const TiledPages>();
    EXPECT_TRUE(drawnProjector(scene, layer, true).isLaid);
    EXPECT_TRUE(drawnProjector(scene, layer, true).selected);
    layer.opacity = 0;
    EXPECT_FALSE(drawnProjector(scene, layer, false).isLaid);
}

TEST(OrganScene, ShowsNoPictureOfAPhotoThatIsHidden) {
    const RenderScene scene = bareBall();
    TextureLayer layer;
    EXPECT_GT(drawnProjector(scene, layer, true).cover, 0);
    layer.visible = false;
    EXPECT_EQ(drawnProjector(scene, layer, true).cover, 0);
    layer.visible = true;
    layer.opacity = 0;
    EXPECT_EQ(drawnProjector(scene, layer, true).cover, 0);
}

TEST(OrganScene, AProjectorsFaceMakesWayForWhoLooksAlongIt) {
    DrawnProjector drawn;
    drawn.projector.pose.translation() = Eigen::Vector3d(0, 0, 0.2);
    const auto shareAt = [&](double degrees) {
        Camera camera;
        camera.target = {0, 0, 0.2};
        camera.eye =
            camera.target + Eigen::Vector3d(std::sin(toRadians(degrees)), 0, std::cos(toRadians(degrees)));
        return faceShare(drawn, camera);
    };
    EXPECT_EQ(shareAt(0), 0);
    EXPECT_EQ(shareAt(20), 0);
    EXPECT_EQ(shareAt(170), 0) << "from behind as well";
    EXPECT_GT(shareAt(45), 0);
    EXPECT_LT(shareAt(45), shareAt(55));
    EXPECT_EQ(shareAt(65), 1);
}

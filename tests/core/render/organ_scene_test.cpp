#include "core/render/organ_scene.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

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

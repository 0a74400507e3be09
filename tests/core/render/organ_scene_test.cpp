#include "core/render/organ_scene.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

using Constants = std::vector<double>;

RenderScene bareBall() {
    const auto mesh = std::make_shared<TriangleMesh>(ball(8, 12));
    return organScene(mesh, edgeNetwork(*mesh), {200, 40, 40});
}

std::optional<std::pair<double, double>> colour(RenderScene& scene, const Constants& constants) {
    return colourSprings(scene, std::make_shared<const Constants>(constants));
}

} // namespace

TEST(OrganScene, ShowsSpringsByThemselvesWhereThereIsNothingElse) {
    EXPECT_FALSE(bareBall().showSprings);
    const auto mesh = std::make_shared<TriangleMesh>();
    mesh->vertices = {{0, 0, 0}, {0.1, 0, 0}};
    EXPECT_TRUE(organScene(mesh, edgeNetwork(*mesh), {0, 0, 0}).showSprings);
}

TEST(OrganScene, ColoursSpringsFromTheLeastToTheLargest) {
    RenderScene scene = bareBall();
    EXPECT_EQ(colour(scene, {30, 10, 20}), std::pair(10.0, 30.0));
    EXPECT_EQ(scene.springValueMinimum, 10);
    EXPECT_EQ(scene.springValueMaximum, 30);
    EXPECT_EQ(*scene.springValues, (Constants{30, 10, 20}));
}

TEST(OrganScene, ColoursOneConstantByARangeAndNothingByNone) {
    for (const double constant : {40.0, 0.0}) {
        RenderScene scene = bareBall();
        EXPECT_EQ(colour(scene, {constant, constant}), std::pair(constant, constant));
        EXPECT_GT(scene.springValueMaximum, scene.springValueMinimum);
    }
    RenderScene scene = bareBall();
    colour(scene, {1, 2});
    EXPECT_EQ(colour(scene, {}), std::nullopt);
    EXPECT_EQ(scene.springValues, nullptr) << "none of what was coloured before";
}

TEST(OrganScene, TellsWhetherAPhotoIsLaid) {
    RenderScene scene = bareBall();
    TextureLayer layer;
    EXPECT_FALSE(drawnProjector(scene, layer, true).isLaid);
    scene.texturePages = std::make_shared<const std::vector<Image>>();
    EXPECT_TRUE(drawnProjector(scene, layer, true).isLaid);
    EXPECT_TRUE(drawnProjector(scene, layer, true).selected);
    layer.opacity = 0;
    EXPECT_FALSE(drawnProjector(scene, layer, false).isLaid);
}

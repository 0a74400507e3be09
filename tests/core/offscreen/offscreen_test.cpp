#include "core/offscreen/offscreen.h"

#include "core/support/errors.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>

using namespace esm;

namespace {

RenderScene sphere() {
    RenderScene scene;
    scene.mesh = std::make_shared<TriangleMesh>(ball(20, 30));
    return scene;
}

Camera frontCamera(const RenderScene& scene, double aspect) {
    return framedCamera(boundingBox(scene.mesh->vertices), StandardView::Front, aspect);
}

bool isRed(const std::uint8_t* pixel) {
    return pixel[0] > pixel[1] + 30;
}

} // namespace

TEST(Offscreen, PictureHasTheSizeAskedForAndIsOpaque) {
    const RenderScene scene = sphere();
    const Image picture = renderOffscreen(scene, frontCamera(scene, 97.0 / 53), 97, 53);
    ASSERT_EQ(picture.width, 97);
    ASSERT_EQ(picture.height, 53);
    ASSERT_EQ(picture.pixels.size(), 4U * 97 * 53);
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4)
        ASSERT_EQ(picture.pixels[i], 255);
    EXPECT_TRUE(isRed(picture.at(48, 26)));
    EXPECT_FALSE(isRed(picture.at(2, 2)));
}

TEST(Offscreen, FixedNodesStandOutAmongTheSprings) {
    RenderScene scene = sphere();
    scene.network = edgeNetwork(*scene.mesh);
    scene.showSprings = true;
    const Camera camera = frontCamera(scene, 1);
    const auto& nodes = scene.network->restPositions;
    const auto nearest = std::max_element(nodes.begin(), nodes.end(),
                                          [](const auto& a, const auto& b) { return a.z() < b.z(); });
    const Eigen::Vector2d place = picturePoint(camera, *nearest, 1).value();
    const auto brightness = [&] {
        const Image picture = renderOffscreen(scene, camera, 300, 300);
        const std::uint8_t* pixel = picture.at(int(place.x() * 300), int(place.y() * 300));
        return pixel[1] + pixel[2];
    };
    const int plain = brightness();
    scene.fixedNodes = {std::uint32_t(nearest - nodes.begin())};
    EXPECT_GT(brightness(), plain + 60);
    scene.showSprings = false;
    EXPECT_GT(brightness(), plain + 60) << "without the springs too";
}

TEST(Offscreen, MarkedNodesFadeWithTheirWeight) {
    RenderScene scene = sphere();
    scene.network = edgeNetwork(*scene.mesh);
    const Camera camera = frontCamera(scene, 1);
    const Image plain = renderOffscreen(scene, camera, 200, 200);
    const auto changed = [&](double weight) {
        scene.marked = MarkedNodes{
            std::make_shared<const std::vector<double>>(scene.network->restPositions.size(), weight),
            {0, 255, 0}};
        const Image picture = renderOffscreen(scene, camera, 200, 200);
        int green = 0;
        for (std::size_t i = 1; i < picture.pixels.size(); i += 4)
            green += std::max(0, picture.pixels[i] - plain.pixels[i]);
        return green;
    };
    const int full = changed(1), faint = changed(0.3);
    EXPECT_EQ(changed(0), 0);
    EXPECT_GT(faint, 1000);
    EXPECT_GT(full, 2 * faint);
}

TEST(Offscreen, SameSceneSamePicture) {
    const RenderScene scene = sphere();
    const Camera camera = frontCamera(scene, 1);
    EXPECT_EQ(renderOffscreen(scene, camera, 200, 200).pixels,
              renderOffscreen(scene, camera, 200, 200).pixels);
}

TEST(Offscreen, ThreadsWaitForEachOther) {
    const RenderScene scene = sphere();
    const Camera camera = frontCamera(scene, 1);
    const auto draw = [&] { return renderOffscreen(scene, camera, 120, 120).pixels; };
    auto first = std::async(std::launch::async, draw), second = std::async(std::launch::async, draw);
    EXPECT_EQ(first.get(), second.get());
}

TEST(Offscreen, LargePicturesMeetWithoutASeam) {
    const RenderScene scene = sphere();
    const Image picture = renderOffscreen(scene, frontCamera(scene, 1), 1100, 1100);
    // Across the border between two parts at column 1024 neighbours differ no more than elsewhere on the
    // ball.
    for (int y = 400; y < 700; ++y)
        for (int channel = 0; channel < 3; ++channel)
            ASSERT_NEAR(picture.at(1023, y)[channel], picture.at(1024, y)[channel], 6) << y;
    EXPECT_TRUE(isRed(picture.at(550, 550)));
}

TEST(Offscreen, ImpossibleSizesAreNamed) {
    const RenderScene scene = sphere();
    const Camera camera = frontCamera(scene, 1);
    EXPECT_THROW(renderOffscreen(scene, camera, 0, 100), InvalidModel);
    EXPECT_THROW(renderOffscreen(scene, camera, 100, -1), InvalidModel);
    EXPECT_THROW(renderOffscreen(scene, camera, 8193, 100), InvalidModel);
}

TEST(Offscreen, NothingToShowIsAnEmptyPicture) {
    const Image picture = renderOffscreen({}, {}, 64, 64);
    EXPECT_FALSE(isRed(picture.at(32, 32)));
}

TEST(Renderer, ImpossiblePositionsKeepTheRestShape) {
    RenderScene scene = sphere();
    const Camera camera = frontCamera(scene, 1);
    const Image rest = renderOffscreen(scene, camera, 100, 100);
    scene.nodePositions.assign(scene.mesh->vertices.size(),
                               Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(renderOffscreen(scene, camera, 100, 100).pixels, rest.pixels);
    scene.nodePositions.assign(scene.mesh->vertices.size(), Eigen::Vector3d::Constant(1e300));
    EXPECT_EQ(renderOffscreen(scene, camera, 100, 100).pixels, rest.pixels);
    scene.nodePositions.assign(3, Eigen::Vector3d::Zero()); // of an older model
    EXPECT_EQ(renderOffscreen(scene, camera, 100, 100).pixels, rest.pixels);
}

TEST(Renderer, FarFromTheOriginTheOrganLooksTheSame) {
    RenderScene scene = sphere();
    const Image here = renderOffscreen(scene, frontCamera(scene, 1), 100, 100);
    TriangleMesh moved = *scene.mesh;
    for (Eigen::Vector3d& vertex : moved.vertices)
        vertex += Eigen::Vector3d(4096, -2048, 8192);
    scene.mesh = std::make_shared<TriangleMesh>(moved);
    const Image there = renderOffscreen(scene, frontCamera(scene, 1), 100, 100);
    std::size_t different = 0;
    for (std::size_t i = 0; i < here.pixels.size(); ++i)
        different += std::abs(here.pixels[i] - there.pixels[i]) > 4 ? 1 : 0;
    EXPECT_LT(different, here.pixels.size() / 200);
}

TEST(Renderer, SurfaceFollowsTheNodes) {
    RenderScene scene = sphere();
    const Camera camera = frontCamera(scene, 1);
    scene.nodePositions = scene.mesh->vertices;
    for (Eigen::Vector3d& position : scene.nodePositions)
        position.x() *= 0.2;
    const Image picture = renderOffscreen(scene, camera, 100, 100);
    EXPECT_TRUE(isRed(picture.at(50, 50)));
    EXPECT_FALSE(isRed(picture.at(75, 50)));
}

TEST(Renderer, FromInsideTheFarWallIsSeen) {
    const RenderScene scene = sphere();
    Camera camera;
    camera.eye = {0, 0, 0.5};
    const Image picture = renderOffscreen(scene, camera, 60, 60);
    for (const int place : {2, 30, 57})
        EXPECT_TRUE(isRed(picture.at(place, place)));
}

TEST(Renderer, OpenSurfacesShowBothSides) {
    RenderScene scene = texturedSquare(quarters(8));
    scene.atlas.reset();
    const Camera back = framedCamera(boundingBox(scene.mesh->vertices), StandardView::Back, 1);
    EXPECT_TRUE(isRed(renderOffscreen(scene, back, 60, 60).at(30, 30)));
}

TEST(Renderer, SpringsBehindTheEyeAreCutOff) {
    RenderScene scene;
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = {{0, 0, 0}, {0, 0, 5}, {0.3, 0, 0}};
    network->springs = {{0, 1, 5}, {1, 2, 5}, {0, 0, 0}};
    scene.network = network;
    Camera camera;
    camera.eye = {0.1, 0.1, 2};
    const Image with = renderOffscreen(scene, camera, 80, 80);
    const Image without = renderOffscreen({}, camera, 80, 80);
    int changed = 0;
    for (std::size_t i = 0; i < with.pixels.size(); i += 4)
        changed += std::abs(with.pixels[i] - without.pixels[i]) > 12 ? 1 : 0;
    EXPECT_GT(changed, 20);
    EXPECT_LT(changed, 800);
}

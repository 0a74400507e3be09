#include "core/offscreen/offscreen.h"
#include "core/render/organ_scene.h"
#include "tests/core/render/subjects.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace esm;

namespace {

RenderScene shiningScene(TriangleMesh mesh, const SurfaceFinish& finish, SceneLight light) {
    const auto shared = std::make_shared<TriangleMesh>(std::move(mesh));
    RenderScene scene = organScene(shared, edgeNetwork(*shared), {120, 60, 50});
    scene.backgroundTop = scene.backgroundBottom = {0, 0, 0};
    scene.finish = finish;
    scene.light = light;
    return scene;
}

Image seenFromFront(const RenderScene& scene) {
    Camera camera;
    camera.eye = {0, 0, 0.5};
    camera.target = {0, 0, 0};
    return renderOffscreen(scene, camera, 400, 400);
}

/// Squares stand for the display's curve in the shaders.
double linearGreen(const Image& picture, int x, int y) {
    return std::pow(picture.at(x, y)[1] / 255.0, 2);
}

std::size_t nearlyWhite(const Image& picture) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4)
        count += *std::min_element(&picture.pixels[i], &picture.pixels[i] + 3) > 200 ? 1 : 0;
    return count;
}

} // namespace

TEST(Finish, OfWetTissueMirrorsTheLamps) {
    for (const SceneLight light : {SceneLight::Room, SceneLight::Endoscope}) {
        const auto whiteOf = [&](const SurfaceFinish& finish) {
            return nearlyWhite(seenFromFront(shiningScene(ball(40, 60), finish, light)));
        };
        EXPECT_EQ(whiteOf({0.9, 0}), 0U);
        EXPECT_GT(whiteOf({0.9, 1}), 5U);
    }
}

TEST(Finish, InAnEndoscopesLightFallsWithTheSquareOfTheDistance) {
    TriangleMesh near = flatSquare(0.02, 4), both = flatSquare(0.1, 4);
    for (Eigen::Vector3d& vertex : both.vertices)
        vertex.z() = -0.5; // behind the near square, twice as far from the eye
    const auto first = static_cast<std::uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), near.vertices.begin(), near.vertices.end());
    for (const Triangle& triangle : near.triangles)
        both.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    const Image picture = seenFromFront(shiningScene(both, {1, 0}, SceneLight::Endoscope));
    const double ofNear = linearGreen(picture, 200, 200), ofFar = linearGreen(picture, 200, 220);
    EXPECT_NEAR(ofNear / ofFar, 4, 0.4);
}

TEST(Finish, InAnEndoscopesLightIsNotBurntOutBesideANearWall) {
    TriangleMesh walls = flatSquare(0.02, 20); // beside the eye, and a far end of as many vertices
    const TriangleMesh end = flatSquare(0.4, 40);
    for (Eigen::Vector3d& vertex : walls.vertices)
        vertex.z() = 0.47;
    const auto first = static_cast<std::uint32_t>(walls.vertices.size());
    for (const Eigen::Vector3d& vertex : end.vertices)
        walls.vertices.emplace_back(vertex.x(), vertex.y(), -0.5);
    for (const Triangle& triangle : end.triangles)
        walls.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    const Image picture = seenFromFront(shiningScene(walls, {1, 0}, SceneLight::Endoscope));
    EXPECT_LT(picture.at(200, 200)[0], 255);
    EXPECT_GT(picture.at(200, 200)[0], 60);
}

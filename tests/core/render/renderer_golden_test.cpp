#include "tests/core/render/golden.h"

#include "core/offscreen/offscreen.h"
#include "core/render/colour_ramp.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

constexpr int width = 320, height = 240;

RenderScene organ(double bump) {
    RenderScene scene;
    TriangleMesh mesh = ball(40, 56, bump);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= 0.09;
    scene.network = edgeNetwork(mesh);
    scene.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
    return scene;
}

Image drawn(const RenderScene& scene, double right = 0, double upwards = 0) {
    const double aspect = double(width) / height;
    const std::vector<Eigen::Vector3d>& points =
        scene.mesh ? scene.mesh->vertices : scene.network->restPositions;
    const Camera front = framedCamera(boundingBox(points), StandardView::Front, aspect);
    const Camera turned = reframed(orbited(front, right, upwards), boundingBox(points), aspect);
    return renderOffscreen(scene, turned, width, height);
}

} // namespace

TEST(Golden, LitSphere) {
    EXPECT_TRUE(matchesGolden(drawn(organ(0)), "sphere"));
}

TEST(Golden, OrganWithASheen) {
    EXPECT_TRUE(matchesGolden(drawn(organ(0.25), 0.4, 0.3), "organ"));
}

TEST(Golden, SpringsInColour) {
    RenderScene scene = organ(0.25);
    auto paint = std::make_shared<std::vector<Paint>>();
    for (const Spring& spring : scene.network->springs) {
        const Eigen::Vector3d middle =
            (scene.network->restPositions[spring.first] + scene.network->restPositions[spring.second]) / 2;
        const Colour colour = rampColour((middle.y() + 0.09) / 0.18);
        paint->push_back(middle.x() < 0 ? Paint{} : Paint{colour[0], colour[1], colour[2], 255});
    }
    scene.springPaint = paint;
    scene.showSprings = true;
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "springs"));
    scene.showSurface = false;
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "springs-alone"));
}

TEST(Golden, NodesInColourAndEdges) {
    RenderScene scene = organ(0.25);
    auto paint = std::make_shared<std::vector<Paint>>();
    for (const Eigen::Vector3d& node : scene.network->restPositions) {
        const Colour colour = rampColour((node.y() + 0.09) / 0.18);
        paint->push_back({colour[0], colour[1], colour[2], std::uint8_t(node.x() < 0 ? 0 : 255)});
    }
    scene.nodePaint = paint;
    scene.showWireframe = true;
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "painted-edges"));
    scene.showSurface = false;
    scene.showNodes = true;
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "edges-nodes"));
}

TEST(Golden, CutOpen) {
    RenderScene scene = organ(0.25);
    scene.showSprings = true;
    scene.cut = CutPlane{Eigen::Vector3d(1, 0.4, 2).normalized(), 0.02};
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "cut"));
}

TEST(Golden, RegionsProjectorAndInstrument) {
    RenderScene scene = organ(0.25);
    DrawnEllipsoid chosen;
    chosen.shape.centre = {0.04, 0.02, 0.07};
    chosen.shape.radii = {0.04, 0.025, 0.03};
    chosen.shape.orientation = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ());
    chosen.colour = {63, 182, 168};
    chosen.selected = true;
    DrawnEllipsoid other = chosen;
    other.shape.centre = {-0.07, 0.03, 0.04};
    other.colour = {122, 162, 247};
    other.selected = false;
    scene.ellipsoids = {chosen, other};
    DrawnProjector projector;
    projector.projector.pose.translation() = Eigen::Vector3d(-0.02, -0.04, 0.16);
    projector.projector.pose.rotate(Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()));
    projector.projector.width = 0.06;
    projector.projector.height = 0.045;
    projector.photo = std::make_shared<Image>(quarters(64));
    projector.selected = true;
    projector.cover = 0.55;
    scene.projectors = {projector};
    scene.instruments = {sphereAt({0.085, -0.05, 0.05}, 0.018)};
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.4, 0.3), "markers"));
}

TEST(Golden, InstrumentsThatAreShafts) {
    RenderScene scene = texturedSquare(quarters(64));
    const auto shaft = [](const Eigen::Vector3d& place, const Eigen::Vector3d& towards) {
        return PlacedCollider{Capsule{0.04, 0.7},
                              {place, Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), towards)}};
    };
    scene.instruments = {shaft({0.15, 0.1, 0.25}, {1, -0.3, 0.5}), shaft({-0.2, -0.1, 0.05}, {0, 0.4, 1})};
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.5, 0.3), "shafts"));
}

TEST(Golden, MotionModelWithoutTriangles) {
    RenderScene scene;
    auto network = std::make_shared<SpringNetwork>();
    for (int i = 0; i < 8; ++i)
        network->restPositions.emplace_back(0.02 * (i & 1), 0.02 * ((i >> 1) & 1), 0.02 * (i >> 2));
    for (std::uint32_t i = 0; i < 7; ++i)
        network->springs.push_back({i, i + 1, 0.02});
    scene.network = network;
    EXPECT_TRUE(matchesGolden(drawn(scene, 0.5, 0.4), "motion-model"));
}

TEST(Golden, TextureOnTheLitSurface) {
    EXPECT_TRUE(matchesGolden(drawn(texturedSquare(quarters(64)), 0.5, 0.3), "texture"));
}

TEST(Texture, UnlitShowsExactlyItsColours) {
    RenderScene scene = texturedSquare(quarters(64));
    scene.unlit = true;
    const Image source = quarters(64), picture = drawn(scene);
    // Points well inside each quarter of the square, which stands in the middle of the picture.
    for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
        const std::uint8_t* seen = picture.at(width / 2 + dx * height / 6, height / 2 + dy * height / 6);
        const std::uint8_t* meant = source.at(32 + dx * 16, 32 + dy * 16);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_EQ(seen[channel], meant[channel]);
    }
}

#include "core/render/cut_plane.h"

#include "core/offscreen/offscreen.h"
#include "core/render/view_state.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace esm;
using Eigen::Vector3d;

namespace {

const Eigen::AlignedBox3d cutBox{Vector3d(-1, -2, -3), Vector3d(1, 2, 5)};

Camera aslant() {
    return orbited(framedCamera(cutBox, StandardView::Front, 1), 0.7, 0.4);
}

} // namespace

TEST(CutPlane, HidesItsShareOfTheOrganFromItsSideOn) {
    const CutPlane plane = cutPlane({CutSide::Front, 0.25}, cutBox, {});
    EXPECT_TRUE(plane.hides({0, 0, 3.01}));
    EXPECT_FALSE(plane.hides({0, 0, 2.99}));
    const CutPlane below = cutPlane({CutSide::Bottom, 0.25}, cutBox, {});
    EXPECT_TRUE(below.hides({0, -1.01, 0}));
    EXPECT_FALSE(below.hides({0, -0.99, 0}));
}

TEST(CutPlane, FromTheViewerItHidesWhatIsNearest) {
    const Camera camera = aslant();
    const Vector3d sight = -cameraAxes(camera).col(2);
    double previous = HUGE_VAL;
    for (const double share : {0.0, 0.3, 0.6, 1.0}) {
        const CutPlane plane = cutPlane({CutSide::Viewer, share}, cutBox, camera);
        EXPECT_NEAR(plane.normal.dot(sight), -1, 1e-12);
        EXPECT_LT(plane.offset, previous);
        previous = plane.offset;
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d place = cutBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
            EXPECT_FALSE(share == 0 && plane.hides(place - 1e-9 * plane.normal));
            EXPECT_TRUE(share < 1 || plane.hides(place + 1e-9 * plane.normal));
        }
    }
}

TEST(CutPlane, NamesAreKnownBothWays) {
    for (const CutSide side : {CutSide::Viewer, CutSide::Right, CutSide::Left, CutSide::Top, CutSide::Bottom,
                               CutSide::Front, CutSide::Back})
        EXPECT_EQ(cutSideFromName(nameOf(side)), side);
    EXPECT_FALSE(cutSideFromName("w"));
}

TEST(CutPlane, LeavesThePartOfARayOnItsSide) {
    const CutPlane plane{Vector3d::UnitZ(), 1};
    const auto from = leftBy(plane, {{0, 0, 5}, {0, 0, -2}});
    EXPECT_TRUE(from->ray.origin.isApprox(Vector3d(0, 0, 1)));
    EXPECT_TRUE(std::isinf(from->length));
    const auto to = leftBy(plane, {{0, 0, -1}, {0, 0, 3}});
    EXPECT_TRUE(to->ray.origin.isApprox(Vector3d(0, 0, -1)));
    EXPECT_DOUBLE_EQ(to->length, 2);
    EXPECT_FALSE(leftBy(plane, {{0, 0, 5}, {1, 0, 0}}));
    EXPECT_TRUE(std::isinf(leftBy(std::nullopt, {{0, 0, 5}, {1, 0, 0}})->length));
}

TEST(CutPlane, PicturesShowTheInsidePlainly) {
    RenderScene scene = texturedSquare(quarters(64)); // its texture is for fronts
    const auto mesh = std::make_shared<TriangleMesh>(ball(40, 56));
    scene.mesh = mesh;
    scene.network = edgeNetwork(*mesh);
    scene.baseColour = {200, 40, 40};
    const Camera camera = framedCamera(boundingBox(mesh->vertices), StandardView::Front, 1);
    const auto brightness = [&] {
        const Image picture = renderOffscreen(scene, camera, 160, 160);
        return picture.at(80, 80)[0] + picture.at(80, 80)[1];
    };
    const int outside = brightness();
    ViewState state;
    state.cut = Cut{CutSide::Front, 0.4};
    showParts(scene, state, camera);
    const int inside = brightness();
    EXPECT_LT(inside, outside - 15) << "the far wall from inside";
    EXPECT_GT(inside, 60) << "is lit";
    state.cut = Cut{CutSide::Front, 1};
    showParts(scene, state, camera);
    const Image nothing = renderOffscreen(scene, camera, 160, 160);
    EXPECT_LT(std::abs(nothing.at(80, 80)[0] - nothing.at(80, 80)[1]), 20) << "background alone";
}

TEST(OrthographicPicture, ShowsEqualThingsEquallyLargeHoweverFar) {
    TriangleMesh mesh;
    for (const double z : {0.0, -3.0}) {
        const double x = z < 0 ? 0.6 : -0.6;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto& [dx, dy] : {std::pair{-0.4, -0.5}, {0.4, -0.5}, {0.4, 0.5}, {-0.4, 0.5}})
            mesh.vertices.emplace_back(x + dx, dy, z);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    }
    RenderScene scene;
    scene.mesh = std::make_shared<TriangleMesh>(mesh);
    scene.baseColour = {0, 255, 0};
    scene.unlit = true;
    const auto box = boundingBox(mesh.vertices);
    const auto pixels = [&](const Camera& camera) {
        const Image picture = renderOffscreen(scene, camera, 200, 200);
        std::array<int, 2> counts{};
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 200; ++x)
                counts[x < 100 ? 0 : 1] += picture.at(x, y)[1] > 150 ? 1 : 0;
        return counts;
    };
    const Camera camera = framedCamera(box, StandardView::Front, 1);
    const auto with = pixels(camera), without = pixels(reframed(orthographic(camera), box, 1));
    EXPECT_GT(with[0], 1.5 * with[1]);
    EXPECT_GT(without[0], 3000);
    EXPECT_NEAR(without[0], without[1], 0.02 * without[0]);
}

#include "core/texture/layers/pose_refinement.h"

#include "core/support/angles.h"
#include "core/texture/layers/surface_beneath.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <cmath>

using namespace esm;
using namespace esm::test;

namespace {

/// Blots and veins of several sizes.
std::shared_ptr<const Photo> veinedPhoto() {
    return makePhoto(512, 512, [](int x, int y) {
        const double wave = std::sin(0.031 * x + 2 * std::sin(0.017 * y)) + std::sin(0.043 * y - 0.013 * x) +
                            0.7 * std::sin(0.11 * x + 0.07 * y) + 0.5 * std::sin(0.19 * y - 0.14 * x);
        const auto red = static_cast<std::uint8_t>(130 + 35 * wave);
        return Colour{red, static_cast<std::uint8_t>(red / 2), static_cast<std::uint8_t>(red / 3), 255};
    });
}

struct SeenTwice {
    TriangleMesh mesh = lumpySurface(30, 40);
    std::vector<TextureLayer> beneath{layerFromAbove(veinedPhoto(), 0.25)};
    TextureLayer second; ///< a photo of what the first one shows, from where it was taken
};

/// From 30° aside, through a camera, in light that falls off from left to right.
SeenTwice seenTwice() {
    SeenTwice seen;
    Projector& camera = seen.second.projector;
    camera.kind = ProjectorKind::Perspective;
    camera.pose =
        Eigen::AngleAxisd(toRadians(30), Eigen::Vector3d(0.6, 0.8, 0)) * Eigen::Translation3d(0.01, 0, 0.35);
    const PhotoSize size{480, 400};
    Image picture = surfaceBeneath(seen.mesh, seen.beneath, baseColour, {camera, size, size});
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                std::uint8_t& value = picture.at(x, y)[channel];
                value = static_cast<std::uint8_t>(value * (0.9 - 0.4 * x / size.width));
            }
    seen.second.photo = std::make_shared<const Photo>(Photo{"second", {}, std::move(picture)});
    return seen;
}

/// Where the two projectors show points of the surface, photo pixels apart; root of the mean square.
double apart(const SeenTwice& seen, const Projector& a, const Projector& b) {
    const PhotoSize size = sizeOf(seen.second.photo->image);
    double squares = 0, count = 0;
    for (const Eigen::Vector3d& vertex : seen.mesh.vertices)
        if (vertex.z() > 0 && vertex.head<2>().norm() < 0.1) {
            squares +=
                (project(a, size, vertex)->head<2>() - project(b, size, vertex)->head<2>()).squaredNorm();
            ++count;
        }
    EXPECT_GT(count, 20);
    return std::sqrt(squares / count);
}

} // namespace

TEST(PoseRefinement, FindsBackFromWhereAPhotoWasMoved) {
    const SeenTwice seen = seenTwice();
    for (const double side : {-1.0, 1.0}) {
        TextureLayer moved = seen.second;
        moved.projector.pose =
            Eigen::Translation3d(0.004 * side, -0.003, 0.005 * side) *
            Eigen::AngleAxisd(toRadians(1.5 * side), Eigen::Vector3d(0.2, 0.3, 0.9).normalized()) *
            moved.projector.pose;
        const double before = apart(seen, moved.projector, seen.second.projector);
        const auto refined = refinedPose(seen.mesh, seen.beneath, moved);
        ASSERT_TRUE(refined);
        EXPECT_GT(before, 4);
        EXPECT_LT(apart(seen, refined->projector, seen.second.projector), 0.5) << before;
        EXPECT_LT(refined->errorAfter, refined->errorBefore / 2);
        EXPECT_NEAR(refined->moved, before, 0.3 * before);
    }
}

TEST(PoseRefinement, LeavesAPhotoThatLiesRight) {
    const SeenTwice seen = seenTwice();
    const auto refined = refinedPose(seen.mesh, seen.beneath, seen.second);
    const Projector& found = refined ? refined->projector : seen.second.projector;
    EXPECT_LT(apart(seen, found, seen.second.projector), 0.2);
}

TEST(PoseRefinement, IsNoneWhereNothingLiesBeneath) {
    const SeenTwice seen = seenTwice();
    EXPECT_FALSE(refinedPose(seen.mesh, {}, seen.second));
    TextureLayer aside = seen.second;
    aside.projector.pose.translation().x() += 1;
    EXPECT_FALSE(refinedPose(seen.mesh, seen.beneath, aside));
}

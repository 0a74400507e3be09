#include "core/geometry/repair.h"
#include "core/texture/layers/composite.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;

namespace {

/// Of 0.1 m, around the origin.
TriangleMesh centredCube() {
    return repair(test::cubeSoup(0.1, Eigen::Vector3d::Constant(-0.05))).mesh;
}

TriangleMesh turnedInsideOut(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

/// From an eye 0.3 m away from the origin, at so many degrees from the z axis, with 8 × 8 squares of 32
/// pixels.
TextureLayer checkerboardInPerspective(double degrees) {
    TextureLayer layer;
    layer.photo = checkerboard();
    layer.projector.pose =
        Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitX()) * Eigen::Translation3d(0, 0, 0.3);
    layer.projector.kind = ProjectorKind::Perspective;
    layer.projector.fieldOfView = 14;
    layer.blendPixels = 0;
    return layer;
}

} // namespace

TEST(PerspectivePhoto, KeepsTheSquaresOfAPerspectivePhotoSeenAtSixtyDegrees) {
    const TriangleMesh mesh = flatSquare(0.1, 2); // few triangles: nothing is linear over one of them
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    const TextureLayer layer = checkerboardInPerspective(60);
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    int compared = 0;
    forEachTexelInside(mesh, atlas, pages,
                       [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                           // The eye's own geometry, without the projector's functions.
                           const Eigen::Vector3d seen = layer.projector.pose.inverse() * point;
                           const double edge = std::tan(7 * M_PI / 180);
                           const double column = 4 + 4 * seen.x() / (-seen.z() * edge),
                                        row = 4 - 4 * seen.y() / (-seen.z() * edge);
                           // Seen slantwise, a texel is up to so many squares high or wide, and so far
                           // colours mix.
                           const double mixed = 2 * 4 / (0.25 * edge * atlas.texelsPerMetre);
                           if (fromLine(column, row) < mixed) return;
                           ++compared;
                           ASSERT_EQ(colour, colourOfSquare(column, row))
                               << point.transpose() << ", column " << column << ", row " << row;
                       });
    EXPECT_GT(compared, 100000);
}

TEST(PerspectivePhoto, ColoursFromAnEyeInsideWhatThePhotoShows) {
    for (const TriangleMesh& mesh : {centredCube(), turnedInsideOut(centredCube())}) {
        const Atlas atlas = packAtlas(mesh, {512, 1, 2});
        TextureLayer layer;
        layer.photo = plainPhoto(green);
        layer.blendPixels = 0;
        layer.projector.kind = ProjectorKind::Perspective; // in the cube's middle, looking along −z
        layer.projector.fieldOfView = 150;                 // reaches around the corners of the far wall
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        const double slope = std::tan(75 * M_PI / 180);
        forEachTexelInside(
            mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                const double edge = std::max(std::abs(point.x()), std::abs(point.y())) + slope * point.z();
                if (std::abs(edge) < 1e-3) return;
                ASSERT_EQ(colour, edge < 0 ? green : base) << point.transpose();
            });
    }
}

TEST(PerspectivePhoto, ColoursNothingThroughAWallThatAnEyeLooksAt) {
    const TriangleMesh mesh = centredCube();
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer;
    layer.photo = plainPhoto(green);
    layer.blendPixels = 0;
    layer.projector.kind = ProjectorKind::Perspective;
    layer.projector.pose.translation().z() = 0.3;
    layer.projector.fieldOfView = 60;
    for (const bool occlusion : {true, false}) {
        layer.projector.occlusion = occlusion;
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages,
                           [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                               const bool isFront = point.z() > 0.05 - 1e-9;
                               if (!isFront && point.z() > 0.0495) return; // the front's very border
                               ASSERT_EQ(colour, isFront || !occlusion ? green : base) << point.transpose();
                           });
    }
}

TEST(PerspectivePhoto, FadesAPhotoWhereSurfaceSlantsOnlyWhenAsked) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {256, 1, 2});
    TextureLayer layer = layerFromAbove(plainPhoto({0, 255, 0, 255}), 0.5);
    layer.projector.pose =
        Eigen::AngleAxisd(72.5 * M_PI / 180, Eigen::Vector3d::UnitX()) * Eigen::Translation3d(0, 0, 1);
    for (const bool falloff : {false, true}) {
        layer.projector.falloff = falloff;
        const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
        forEachTexelInside(mesh, atlas, pages, [&](auto&, const Colour& colour, std::size_t) {
            ASSERT_TRUE(isNear(colour, falloff ? Colour{100, 178, 25, 255} : green, 1));
        });
    }
}

TEST(PerspectivePhoto, TakesNothingFromAnEyeInTheSurface) {
    const TriangleMesh mesh = flatSquare(0.1, 3);
    const Atlas atlas = packAtlas(mesh, {128, 1, 2});
    TextureLayer layer = checkerboardInPerspective(0);
    for (const double height : {0.0, 1e-300, 1e-12, -1e-12}) {
        layer.projector.pose =
            Eigen::Translation3d(0, 0, height) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX());
        EXPECT_NO_THROW(composite(mesh, atlas, {layer}, baseColour));
        EXPECT_NO_THROW(coverage(mesh, atlas, layer));
    }
}

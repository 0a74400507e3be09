#include "core/texture/atlas/distortion.h"

#include "tests/support/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace esm {
namespace {

/// The plane's points mapped onto the page.
Atlas mapped(const TriangleMesh& mesh, const Eigen::Matrix2d& map) {
    Atlas atlas;
    atlas.page.assign(mesh.triangles.size(), 0);
    for (const Triangle& triangle : mesh.triangles) {
        auto& corners = atlas.corners.emplace_back();
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = map * mesh.vertices[triangle[i]].head<2>();
    }
    return atlas;
}

TEST(Distortion, OfALinearMapIsThatOfItsSingularValues) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    Eigen::Matrix2d map;
    map << 3000, 0, 0, 1000;
    map = Eigen::Rotation2Dd(0.7) * map * Eigen::Rotation2Dd(0.3);
    const Distortion distortion = distortionOf(mesh, mapped(mesh, map));
    for (const double value : {distortion.angle.mean, distortion.angle.percentile95, distortion.angle.worst})
        EXPECT_NEAR(value, 3, 1e-9);
    for (const double value : {distortion.area.mean, distortion.area.percentile95, distortion.area.worst})
        EXPECT_NEAR(value, 1, 1e-9) << "one density everywhere";
    EXPECT_EQ(distortion.flipped + distortion.collapsed, 0U);
}

TEST(Distortion, OfAShearIsTheGoldenRatiosSquare) {
    const TriangleMesh mesh = flatSquare(0.1, 1);
    Eigen::Matrix2d shear;
    shear << 1, 1, 0, 1;
    // Its singular values are the golden ratio and its inverse.
    EXPECT_NEAR(distortionOf(mesh, mapped(mesh, shear)).angle.worst, (3 + std::sqrt(5.0)) / 2, 1e-9);
}

TEST(Distortion, ComparesDensityWithThatOfTheWholeByArea) {
    TriangleMesh mesh = flatSquare(0.1, 1);
    Atlas atlas = mapped(mesh, 1000 * Eigen::Matrix2d::Identity());
    for (Eigen::Vector2d& corner : atlas.corners[1])
        corner *= 2; // four times as dense as the other half: 1 and 4 against a mean of 2.5
    const Distortion distortion = distortionOf(mesh, atlas);
    EXPECT_NEAR(distortion.area.worst, 2.5, 1e-9);
    EXPECT_NEAR(distortion.area.mean, (2.5 + 1.6) / 2, 1e-9);
    EXPECT_NEAR(distortion.angle.worst, 1, 1e-9);
}

TEST(Distortion, DoesNotLetCollapsedTrianglesSayWhichWayRoundAPatchIs) {
    TriangleMesh mesh = flatSquare(0.1, 1);
    mesh.vertices[mesh.triangles[1][2]] *= 3; // the larger half
    Eigen::Matrix2d mirrored;
    mirrored << 1000, 0, 0, -1000;
    Atlas atlas = mapped(mesh, mirrored);
    atlas.corners[1][2] = atlas.corners[1][1];
    const Distortion distortion = distortionOf(mesh, atlas);
    EXPECT_EQ(distortion.flipped, 0U);
    EXPECT_EQ(distortion.collapsed, 1U);
}

TEST(Distortion, LeavesOutTheWorst5PercentOfTheAreaByTheirArea) {
    TriangleMesh mesh = flatSquare(0.1, 10);
    Atlas atlas = mapped(mesh, 1000 * Eigen::Matrix2d::Identity());
    const auto stretch = [&](std::size_t triangles) {
        for (std::size_t i = 0; i < triangles; ++i)
            for (Eigen::Vector2d& corner : atlas.corners[i])
                corner.x() *= 7;
    };
    stretch(10);
    EXPECT_NEAR(distortionOf(mesh, atlas).angle.percentile95, 1, 1e-9) << "10 of 200";
    EXPECT_NEAR(distortionOf(mesh, atlas).angle.mean, 1.3, 1e-9);
    atlas = mapped(mesh, 1000 * Eigen::Matrix2d::Identity());
    stretch(11);
    EXPECT_NEAR(distortionOf(mesh, atlas).angle.percentile95, 7, 1e-9) << "11 of 200";
}

TEST(Distortion, CountsTrianglesThatAreFoldedOver) {
    const TriangleMesh mesh = flatSquare(0.1, 1);
    Atlas atlas = mapped(mesh, 1000 * Eigen::Matrix2d::Identity());
    for (auto& corners : atlas.corners)
        for (Eigen::Vector2d& corner : corners)
            corner.x() = -corner.x();
    EXPECT_EQ(distortionOf(mesh, atlas).flipped, 0U) << "mirrored as a whole";
    // The corner that the second triangle alone has goes over its opposite side, onto the first triangle.
    ASSERT_EQ(mesh.triangles[1][2], 2U);
    atlas.corners[1][2] = atlas.corners[0][1];
    EXPECT_EQ(distortionOf(mesh, atlas).flipped, 1U);
}

TEST(Distortion, CountsTrianglesThatLoseTheirAreaAndLeavesThemOut) {
    TriangleMesh mesh = flatSquare(0.1, 1);
    Atlas atlas = mapped(mesh, 1000 * Eigen::Matrix2d::Identity());
    atlas.corners[1][2] = atlas.corners[1][1];
    EXPECT_EQ(distortionOf(mesh, atlas).collapsed, 1U);
    EXPECT_NEAR(distortionOf(mesh, atlas).angle.worst, 1, 1e-9);
    mesh.vertices[2] = mesh.vertices[3]; // now it has none on the surface either
    EXPECT_EQ(distortionOf(mesh, atlas).collapsed, 0U);
}

TEST(Distortion, OfLayoutsThatKeepShapesIsNone) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    for (const AtlasLayout layout :
         {AtlasLayout::Rows, AtlasLayout::MatchedRows, AtlasLayout::UnfoldedGroups}) {
        const Distortion distortion = distortionOf(mesh, packAtlas(mesh, {512, 1, 2, layout}));
        for (const double worst : {distortion.angle.worst, distortion.area.worst})
            EXPECT_NEAR(worst, 1, 1e-6) << wordOf(layout);
        EXPECT_EQ(distortion.flipped + distortion.collapsed, 0U) << wordOf(layout);
    }
}

TEST(Distortion, OfNothingIsNone) {
    const Distortion distortion = distortionOf({}, {});
    EXPECT_EQ(distortion.angle.worst, 1);
    EXPECT_EQ(distortion.area.worst, 1);
}

} // namespace
} // namespace esm

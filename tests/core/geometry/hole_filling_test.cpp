#include "core/geometry/hole_filling.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/adjacency.h"
#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/support/cut_ball.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

using test::soupOf;

RepairedMesh filled(const TriangleMesh& mesh, std::size_t edges) {
    RepairOptions options;
    options.holeEdges = edges;
    return repair(soupOf(mesh), options);
}

/// Without the triangles that have one of these corners.
TriangleMesh without(TriangleMesh mesh, const std::vector<std::uint32_t>& vertices) {
    std::erase_if(mesh.triangles, [&](const Triangle& triangle) {
        return std::any_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
            return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
        });
    });
    return mesh;
}

/// Its squares beside each other, so many in a row and in a column.
TriangleMesh withWindow(int cells, int from, int to) {
    TriangleMesh sheet = flatSquare(0.1, cells);
    std::erase_if(sheet.triangles, [&](const Triangle& triangle) {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const std::uint32_t vertex : triangle)
            centre += sheet.vertices[vertex] / 3;
        const Eigen::Array3d cell = (centre.array() / 0.1 + 0.5) * cells;
        return (cell.head<2>() > from).all() && (cell.head<2>() < to).all();
    });
    return sheet;
}

TEST(HoleFilling, FillsAHoleInABallAlongItsSurface) {
    for (const std::size_t cut : {1U, 2U, 9U}) {
        std::vector<std::uint32_t> gone;
        for (std::uint32_t i = 0; i < cut; ++i)
            gone.push_back(3000 + i);
        const RepairedMesh mended = filled(without(test::ball(), gone), 40);
        EXPECT_EQ(mended.report.filledHoles, 1U);
        EXPECT_TRUE(mended.report.isClosed());
        EXPECT_EQ(mended.report.nonManifoldEdges, 0U);
        EXPECT_EQ(mended.mesh.vertices.size(), test::ball().vertices.size() - cut);
        EXPECT_NEAR(enclosedVolume(mended.mesh) / enclosedVolume(test::ball()), 1, 1e-3);
        EXPECT_NEAR(surfaceArea(mended.mesh) / surfaceArea(test::ball()), 1, 1e-3);
        EXPECT_THAT(mended.report.warnings, testing::Contains(testing::StartsWith("1 hole filled, with ")));
    }
}

TEST(HoleFilling, FillsAFlatHoleWithoutOverlap) {
    for (const int to : {5, 9, 14}) {
        const TriangleMesh window = withWindow(20, 4, to);
        const auto edges = static_cast<std::size_t>(4 * (to - 4));
        const RepairedMesh mended = filled(window, edges);
        EXPECT_EQ(mended.report.filledHoles, 1U);
        EXPECT_EQ(mended.report.boundaryEdges, 80U); // its outer border
        EXPECT_EQ(mended.mesh.triangles.size(), window.triangles.size() + edges - 2);
        EXPECT_NEAR(surfaceArea(mended.mesh), 0.01, 1e-9);
        EXPECT_EQ(filled(window, edges - 1).report.filledHoles, 0U);
    }
}

TEST(HoleFilling, FillsAConcaveHoleWithinItsBorder) {
    // An L: two windows that meet.
    TriangleMesh sheet = withWindow(20, 4, 8);
    const TriangleMesh other = withWindow(20, 6, 14);
    std::erase_if(sheet.triangles, [&](const Triangle& triangle) {
        return std::find(other.triangles.begin(), other.triangles.end(), triangle) == other.triangles.end();
    });
    const RepairedMesh mended = filled(sheet, 60);
    EXPECT_EQ(mended.report.filledHoles, 1U);
    EXPECT_NEAR(surfaceArea(mended.mesh), 0.01, 1e-9);
    EXPECT_EQ(mended.report.flippedTriangles, 0U);
}

TEST(HoleFilling, LeavesTheOuterBorderOfASheetOpen) {
    const RepairedMesh mended = filled(flatSquare(0.1, 20), 80);
    EXPECT_EQ(mended.report.filledHoles, 0U);
    EXPECT_EQ(mended.report.boundaryEdges, 80U);
    EXPECT_THAT(mended.report.warnings, testing::Contains(testing::HasSubstr("1 hole left open")));
}

TEST(HoleFilling, FillsHolesThatTouchInAVertexEachByItself) {
    TriangleMesh sheet = withWindow(20, 4, 8);
    const TriangleMesh other = withWindow(20, 8, 12);
    std::erase_if(sheet.triangles, [&](const Triangle& triangle) {
        return std::find(other.triangles.begin(), other.triangles.end(), triangle) == other.triangles.end();
    });
    const RepairedMesh mended = filled(sheet, 16);
    EXPECT_EQ(mended.report.filledHoles, 2U);
    EXPECT_EQ(mended.report.boundaryEdges, 80U);
    EXPECT_EQ(mended.report.nonManifoldEdges, 0U);
    EXPECT_NEAR(surfaceArea(mended.mesh), 0.01, 1e-9);
}

TEST(HoleFilling, FillsAHoleBesideAnOuterBorderAndLeavesThatOpen) {
    const RepairedMesh mended = filled(withWindow(20, 1, 4), 12);
    EXPECT_EQ(mended.report.filledHoles, 1U);
    EXPECT_EQ(mended.report.boundaryEdges, 80U);
}

TEST(HoleFilling, ClosesTheEndsOfATubeAndTurnsItOutwards) {
    TriangleMesh tube = test::torus(24, 12);
    std::erase_if(tube.triangles, [](const Triangle& triangle) {
        return std::all_of(triangle.begin(), triangle.end(),
                           [](std::uint32_t vertex) { return vertex < 60; });
    });
    for (Triangle& triangle : tube.triangles)
        std::swap(triangle[0], triangle[1]);
    const RepairedMesh mended = filled(tube, 12);
    EXPECT_EQ(mended.report.filledHoles, 2U);
    EXPECT_TRUE(mended.report.isClosed());
    EXPECT_GT(enclosedVolume(mended.mesh), 0);
    EXPECT_NEAR(enclosedVolume(mended.mesh) / enclosedVolume(test::torus(24, 12)), 20. / 24, 0.01);
}

TEST(HoleFilling, LeavesASingleTriangleAsItIs) {
    const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_EQ(filled(triangle, 3).report.filledHoles, 0U);
}

TEST(HoleFilling, RefusesNumbersBeyondItsLimits) {
    for (const std::size_t edges : {1U, 2U, 501U, 1000000U})
        EXPECT_THROW(filled(test::ball(), edges), InvalidModel) << edges;
    EXPECT_NO_THROW(filled(test::ball(), mostHoleEdges));
}

class HoleFillingData : public testing::TestWithParam<const char*> {};

TEST_P(HoleFillingData, FillsHolesOfOrgansWithoutFaultyEdges) {
    const auto file = sharedData("meshes") / GetParam();
    ESM_SKIP_WITHOUT(file);
    const PolygonSoup soup = readMeshFile(file);
    const RepairedMesh open = repair(soup);
    RepairOptions options;
    options.holeEdges = 200;
    const RepairedMesh mended = repair(soup, options);
    EXPECT_GT(mended.report.filledHoles, 0U);
    EXPECT_EQ(mended.report.nonManifoldEdges, open.report.nonManifoldEdges);
    EXPECT_LT(mended.report.boundaryEdges, open.report.boundaryEdges);
    EXPECT_EQ(mended.mesh.vertices, open.mesh.vertices);
}

INSTANTIATE_TEST_SUITE_P(OpenOrgans, HoleFillingData,
                         testing::Values("VH_F_Fallopian_Tube_L.glb", "VH_F_Uterus.glb", "VH_M_Liver.glb",
                                         "VH_F_Vasculature.glb", "SBU_F_Intestine_Large.glb",
                                         "GCA-00020-transverse-colon-open.vtk", "sofa-head-quads-uv.obj",
                                         "sofa-skull-and-teeth-coarse.obj"));

} // namespace
} // namespace esm

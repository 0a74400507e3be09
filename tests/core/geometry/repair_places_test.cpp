#include "core/geometry/repair.h"

#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace esm {
namespace {

/// Where a vertex lies says its place here, so that each corner can be asked.
Eigen::Vector2d rightPlace(const Eigen::Vector3d& vertex) {
    return {0.25 * vertex.x() + 0.1 * vertex.z(), 0.25 * vertex.y() + 0.2 * vertex.z()};
}

PolygonSoup withPlaces(PolygonSoup soup) {
    for (const std::vector<std::uint32_t>& polygon : soup.polygons) {
        std::vector<Eigen::Vector2d>& places = soup.textureCoordinates.emplace_back();
        for (const std::uint32_t vertex : polygon)
            places.push_back(rightPlace(soup.vertices[vertex]));
    }
    return soup;
}

void expectRightPlaces(const TriangleMesh& mesh) {
    ASSERT_EQ(mesh.textureCoordinates.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            EXPECT_EQ(mesh.textureCoordinates[i][corner],
                      rightPlace(mesh.vertices[mesh.triangles[i][corner]]))
                << i;
}

TEST(RepairPlaces, GoWithTheTrianglesOfSplitAndWeldedPolygons) {
    const RepairedMesh cube = repair(withPlaces(test::cubeSoup(2)));
    EXPECT_EQ(cube.report.mergedVertices, 16U);
    expectRightPlaces(cube.mesh);
    EXPECT_TRUE(cube.report.warnings.empty());
}

TEST(RepairPlaces, TurnAndGoWithTriangles) {
    PolygonSoup soup = test::soupOf(test::torus());
    for (std::size_t i = 0; i < soup.polygons.size(); i += 3)
        std::reverse(soup.polygons[i].begin(), soup.polygons[i].end());
    soup.polygons.insert(soup.polygons.begin() + 4, {soup.polygons[2], {0, 0, 1}});
    const RepairedMesh torus = repair(withPlaces(soup));
    EXPECT_GT(torus.report.flippedTriangles, 0U);
    EXPECT_EQ(torus.report.removedTriangles(), 2U);
    expectRightPlaces(torus.mesh);
}

TEST(RepairPlaces, OfOneVertexDifferAtEachSideOfASeam) {
    PolygonSoup soup;
    soup.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    soup.polygons = {{0, 1, 2}, {0, 2, 3}};
    soup.textureCoordinates = {{{0, 0}, {0.4, 0}, {0.4, 0.4}}, {{0.5, 0.5}, {0.9, 0.9}, {0.5, 0.9}}};
    const RepairedMesh square = repair(soup);
    EXPECT_EQ(square.mesh.textureCoordinates[0][2], Eigen::Vector2d(0.4, 0.4));
    EXPECT_EQ(square.mesh.textureCoordinates[1][1], Eigen::Vector2d(0.9, 0.9));
}

TEST(RepairPlaces, AreDroppedWithAWordWhereTrianglesAreAdded) {
    PolygonSoup open = test::cubeSoup(2);
    open.polygons.pop_back();
    RepairOptions options;
    options.holeEdges = 4;
    const RepairedMesh filled = repair(withPlaces(open), options);
    EXPECT_EQ(filled.report.filledHoles, 1U);
    EXPECT_TRUE(filled.mesh.textureCoordinates.empty());
    EXPECT_THAT(filled.report.warnings,
                testing::Contains(testing::HasSubstr("dropped: 2 of 12 triangles have none")));
    expectRightPlaces(repair(withPlaces(open)).mesh);
}

TEST(RepairPlaces, AreDroppedWithAWordWhereAFaceHasNone) {
    PolygonSoup soup = withPlaces(test::cubeSoup(2));
    soup.textureCoordinates[3].clear();
    const RepairedMesh cube = repair(soup);
    EXPECT_TRUE(cube.mesh.textureCoordinates.empty());
    EXPECT_THAT(cube.report.warnings, testing::Contains(testing::HasSubstr("2 of 12")));
}

} // namespace
} // namespace esm

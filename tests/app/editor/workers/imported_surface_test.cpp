#include "app/editor/workers/imported_surface.h"

#include "app/editor/dialogs/import_report.h"
#include "tests/support/steady_progress.h"

using namespace esm;

namespace {

/// A tetrahedron of this size, and a triangle apart from it.
PolygonSoup tetrahedronAndTriangle(double size) {
    PolygonSoup soup;
    soup.vertices = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {9, 9, 9}, {11, 9, 9}, {9, 10, 9}};
    soup.polygons = {{4, 5, 6}, {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return soup;
}

} // namespace

TEST(ImportedSurface, KnowsThePartsLargestFirst) {
    const ImportedSurface all = importedSurface(tetrahedronAndTriangle(3), {});
    ASSERT_EQ(all.parts.size(), 2U);
    EXPECT_EQ(all.parts[0].triangles, 4U);
    EXPECT_EQ(all.parts[0].extent, Eigen::Vector3d(3, 3, 3));
    EXPECT_EQ(all.parts[1].triangles, 1U);
    EXPECT_EQ(all.parts[1].extent, Eigen::Vector3d(2, 1, 0));
    EXPECT_EQ(all.extent, Eigen::Vector3d(11, 10, 9));
    RepairOptions largest;
    largest.keep = KeepParts::Largest;
    EXPECT_EQ(importedSurface(tetrahedronAndTriangle(3), largest).extent, Eigen::Vector3d(3, 3, 3));
}

TEST(ImportedSurface, KnowsTheOpenBorders) {
    PolygonSoup soup = tetrahedronAndTriangle(3);
    const ImportedSurface all = importedSurface(soup, {});
    ASSERT_EQ(all.borders.size(), 1U);
    EXPECT_EQ(all.borders[0].loop.size(), 3U);
    EXPECT_EQ(all.report.boundaryEdges, 3U);
    soup.polygons.erase(soup.polygons.begin());
    EXPECT_TRUE(importedSurface(soup, {}).borders.empty());
}

TEST(ImportedSurface, KnowsWhereItRunsThroughItself) {
    EXPECT_EQ(importedSurface(tetrahedronAndTriangle(3), {}).meetingPairs, 0U);
    PolygonSoup soup = tetrahedronAndTriangle(3);
    soup.vertices[4] = {0.5, 0.5, -1}; // the triangle now cuts the side between the first, second and third
    soup.vertices[5] = {0.6, 0.5, -1};
    soup.vertices[6] = {0.5, 0.6, 0.5};
    const ImportedSurface crossed = importedSurface(soup, {});
    EXPECT_EQ(crossed.meetingPairs, 1U);
    EXPECT_TRUE(reportLines(crossed).join(' ').contains("1 pair of triangles meets"));
}

TEST(ImportedSurface, TellsHowFarItIs) {
    const PolygonSoup soup = tetrahedronAndTriangle(3);
    test::expectGoodProgress([&](const Progress& progress) { importedSurface(soup, {}, progress); });
}

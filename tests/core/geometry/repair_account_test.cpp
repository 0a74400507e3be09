#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/border_loops.h"
#include "core/geometry/repair.h"
#include "tests/support/cut_ball.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

using test::cubeSoup;
using test::cutBall;
using test::soupOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double sawn = 6e-4; ///< m, the width of the cut

/// The ball without three of its triangles, far apart, and a slit.
PolygonSoup leakyBall() {
    PolygonSoup soup = soupOf(cutBall().mesh);
    for (const std::size_t i : {12000U, 9000U, 500U})
        soup.polygons.erase(soup.polygons.begin() + static_cast<std::ptrdiff_t>(i));
    return soup;
}

void turn(std::vector<std::uint32_t>& polygon) {
    std::swap(polygon[1], polygon[2]);
}

void turnAll(PolygonSoup& soup) {
    for (auto& polygon : soup.polygons)
        turn(polygon);
}

/// A triangle that stands on an edge of the cube.
PolygonSoup cubeWithFlap() {
    PolygonSoup soup = cubeSoup();
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {{0, 0, 0}, {1, 0, 0}, {0.5, -1, -1}});
    soup.polygons.push_back({first, first + 1, first + 2});
    return soup;
}

TEST(RepairAccount, AddsUpFromTheFileToWhatIsLeft) {
    RepairOptions options;
    options.slitWidth = sawn;
    EXPECT_THAT(
        repair(leakyBall(), options).report.warnings,
        Contains("171 border edges in the file, 162 closed with slits: 9 left, the surface is not closed"));
    options.holeEdges = 3;
    const RepairReport closed = repair(leakyBall(), options).report;
    EXPECT_EQ(closed.filledHoles, 3U);
    EXPECT_EQ(closed.filledHoleEdges, 9U);
    EXPECT_EQ(closed.boundaryEdgesFound(), 171U);
    EXPECT_THAT(closed.warnings,
                Contains("171 border edges in the file, 162 closed with slits, 9 closed with "
                         "holes: none left"));
    EXPECT_THAT(repair(leakyBall()).report.warnings, Contains("171 border edges: the surface is not closed"));
}

TEST(RepairAccount, CountsTheBorderEdgesOfDroppedParts) {
    PolygonSoup soup = leakyBall();
    test::append(soup, {{{9, 9, 9}, {8, 9, 9}, {9, 8, 9}}, {{0, 1, 2}}});
    RepairOptions options;
    options.keep = KeepParts::Largest;
    const RepairReport report = repair(soup, options).report;
    EXPECT_EQ(report.droppedPartEdges, 3U);
    EXPECT_EQ(report.boundaryEdgesFound(), 174U);
    EXPECT_EQ(report.boundaryEdges, 171U);
}

TEST(RepairAccount, SaysWhichBorderEdgesGoAroundNoHole) {
    RepairOptions options;
    options.holeEdges = 500;
    const RepairReport report = repair(cubeWithFlap(), options).report;
    EXPECT_EQ(report.boundaryEdges, 2U);
    EXPECT_EQ(report.filledHoles + report.refusedHoles, 0U);
    EXPECT_THAT(report.warnings, Contains(HasSubstr("2 border edges around no hole")));
    EXPECT_THAT(repair(leakyBall()).report.warnings, Not(Contains(HasSubstr("around no hole"))));
}

TEST(RepairAccount, SaysHowManyEdgesDroppedTrianglesLeave) {
    PolygonSoup soup = cubeSoup();
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {{0, 0, 0}, {1, 0, 0}, {0.5, -1, -1}});
    soup.polygons.push_back({first, first + 1, first + 2});
    soup.polygons.push_back({first + 1, first, first + 2}); // its other side
    const RepairReport report = repair(soup).report;
    EXPECT_EQ(report.boundaryEdgesBefore, 0U);
    EXPECT_THAT(report.warnings, Contains("0 border edges in the file, 2 more once faulty triangles are "
                                          "dropped: 2 left, the surface is not closed"));
}

// Open it keeps the direction of most of its triangles, closed it faces outwards: those that were turned to
// agree with the rest are turned back.
TEST(RepairAccount, CountsATriangleThatIsTurnedTwiceAsLeft) {
    PolygonSoup soup = leakyBall();
    turnAll(soup);
    for (std::size_t i = 0; i < 20; ++i)
        turn(soup.polygons[40 * i]);
    const std::size_t all = soup.polygons.size();
    EXPECT_EQ(repair(soup).report.flippedTriangles, 20U);
    RepairOptions options;
    options.slitWidth = sawn;
    options.holeEdges = 3;
    const RepairReport report = repair(soup, options).report;
    EXPECT_TRUE(report.isClosed());
    EXPECT_EQ(report.flippedTriangles, all - 20);
}

TEST(RepairAccount, CountsADividedTriangleOnce) {
    test::CutMesh cut = cutBall();
    test::thinOut(cut, 3);
    PolygonSoup soup = soupOf(cut.mesh);
    turnAll(soup);
    const std::size_t all = soup.polygons.size() - repair(soup).report.removedTriangles();
    RepairOptions options;
    options.slitWidth = 2 * sawn;
    const RepairedMesh mended = repair(soup, options);
    EXPECT_GT(mended.mesh.triangles.size(), all);
    EXPECT_TRUE(mended.report.isClosed());
    EXPECT_EQ(mended.report.flippedTriangles, all);
}

class RepairAccountData : public testing::TestWithParam<const char*> {};

TEST_P(RepairAccountData, AddsUpOnEveryOrganWithAnyOptions) {
    const auto file = sharedData("meshes") / GetParam();
    ESM_SKIP_WITHOUT(file);
    const PolygonSoup soup = readMeshFile(file);
    const std::size_t found = repair(soup).report.boundaryEdges;
    const double extent = boundingBox(soup.vertices).sizes().maxCoeff();
    for (const RepairOptions& options :
         {RepairOptions{0, KeepParts::All, 0, 500}, RepairOptions{0, KeepParts::All, 2e-3 * extent, 30},
          RepairOptions{0, KeepParts::Largest, 2e-2 * extent, 500}}) {
        const RepairedMesh mended = repair(soup, options);
        EXPECT_EQ(mended.report.boundaryEdgesFound(), found);
        const std::vector<BorderLoop> loops = bordersOf(mended.mesh.triangles).loops;
        EXPECT_EQ(mended.report.refusedHoles, static_cast<std::size_t>(std::count_if(
                                                  loops.begin(), loops.end(), [&](const BorderLoop& loop) {
                                                      return loop.size() <= options.holeEdges;
                                                  })));
    }
}

INSTANTIATE_TEST_SUITE_P(OpenOrgans, RepairAccountData,
                         testing::Values("GCA-VHF-large-intestine.vtk", "VH_F_Fallopian_Tube_L.glb",
                                         "VH_F_Uterus.glb", "VH_M_Liver.glb", "SBU_F_Intestine_Large.glb",
                                         "sks-tumour.ply", "sofa-skull-and-teeth-coarse.obj"));

} // namespace
} // namespace esm

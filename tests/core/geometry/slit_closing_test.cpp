#include "core/geometry/slit_closing.h"

#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/adjacency.h"
#include "core/geometry/border_loops.h"
#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/support/cut_ball.h"
#include "tests/support/rounds.h"
#include "tests/support/shared_data.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace esm {
namespace {

using test::BallShape;
using test::cutBall;
using test::CutMesh;
using test::cutOpen;
using test::RingCut;
using test::soupOf;

constexpr double gap = 6e-4; // m

RepairedMesh closed(const TriangleMesh& mesh, double width) {
    RepairOptions options;
    options.slitWidth = width;
    return repair(soupOf(mesh), options);
}

/// Closed, of one side, and nowhere as thin as a line.
void expectSound(const RepairedMesh& repaired) {
    EXPECT_EQ(repaired.report.boundaryEdges, 0U);
    EXPECT_EQ(repaired.report.nonManifoldEdges, 0U);
    EXPECT_EQ(repaired.report.inconsistentEdges, 0U);
    EXPECT_EQ(repaired.report.components, 1U);
    const auto& vertices = repaired.mesh.vertices;
    for (const Triangle& t : repaired.mesh.triangles) {
        const Eigen::Vector3d normal =
            (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
        EXPECT_GT(normal.norm(), 1e-12);
        // Of a ball around the origin: nothing folds over.
        EXPECT_GT(normal.normalized().dot((vertices[t[0]] + vertices[t[1]] + vertices[t[2]]).normalized()),
                  0.5);
    }
}

void expectMended(const CutMesh& cut, double width, std::size_t edges) {
    EXPECT_EQ(bordersOf(cut.mesh.triangles).edgeCount(), edges);
    const RepairedMesh mended = closed(cut.mesh, width);
    EXPECT_EQ(mended.report.boundaryEdgesBefore, edges);
    EXPECT_EQ(mended.report.closedSlitEdges, edges);
    EXPECT_THAT(mended.report.warnings,
                testing::Contains(std::to_string(edges) + " border edges of slits closed"));
    expectSound(mended);
    EXPECT_NEAR(enclosedVolume(mended.mesh) / enclosedVolume(test::ball()), 1, 1e-3);
}

TEST(SlitClosing, ClosesABallCutOpenAlong162Edges) {
    expectMended(cutBall(), gap, 162);
    const RepairedMesh mended = closed(cutBall().mesh, gap);
    EXPECT_EQ(mended.mesh.vertices.size(), test::ball().vertices.size());
    EXPECT_EQ(mended.mesh.triangles.size(), test::ball().triangles.size());
}

TEST(SlitClosing, ClosesACrookedCut) {
    expectMended(cutBall({.sway = 5e-4}), gap, 162);
}

TEST(SlitClosing, ClosesACutWhoseSidesOverlap) {
    expectMended(cutBall({.gap = -gap}), gap, 162);
}

TEST(SlitClosing, ClosesACutWithFewerVerticesOnOneSide) {
    for (const std::size_t every : {2U, 3U, 5U}) {
        CutMesh cut = cutBall();
        test::thinOut(cut, every);
        const RepairedMesh dropped = repair(soupOf(cut.mesh));
        cut.mesh = dropped.mesh;
        expectMended(cut, gap, 162 - 79 / every);
    }
}

TEST(SlitClosing, ClosesACutWhoseSidesHaveNoVertexAcrossFromEachOther) {
    // Both halves of a globe apart, one of them turned by half a segment.
    const BallShape shape;
    TriangleMesh halves = test::ball(shape);
    const CutMesh whole = cutBall({.edges = shape.segments + 1, .gap = 0}, shape);
    halves = whole.mesh;
    const Eigen::AngleAxisd turn(M_PI / shape.segments, Eigen::Vector3d::UnitY());
    std::vector<bool> isLower(halves.vertices.size(), false);
    for (const Triangle& t : halves.triangles) {
        const double centre =
            halves.vertices[t[0]].y() + halves.vertices[t[1]].y() + halves.vertices[t[2]].y();
        for (const std::uint32_t vertex : t)
            if (centre < 0) isLower[vertex] = true;
    }
    for (std::size_t i = 0; i < halves.vertices.size(); ++i)
        halves.vertices[i] =
            isLower[i] ? turn * halves.vertices[i] - Eigen::Vector3d(0, gap, 0) : halves.vertices[i];
    EXPECT_EQ(repair(soupOf(halves)).report.components, 2U);
    const RepairedMesh mended = closed(halves, gap * 1.05); // edges cut the corners of the circle
    expectSound(mended);
    EXPECT_EQ(mended.report.closedSlitEdges, 2U * shape.segments);
}

TEST(SlitClosing, LeavesAWedgeOpenWhereItIsWider) {
    CutMesh cut = cutBall({.gap = 0});
    for (std::size_t i = 0; i < cut.upper.size(); ++i)
        cut.mesh.vertices[cut.upper[i]].y() += 3e-3 * static_cast<double>(i) / 80;
    const RepairedMesh mended = closed(cut.mesh, gap);
    EXPECT_GT(mended.report.closedSlitEdges, 25U);
    EXPECT_GT(mended.report.boundaryEdges, 100U);
    EXPECT_EQ(mended.report.closedSlitEdges + mended.report.boundaryEdges, mended.report.boundaryEdgesBefore);
    EXPECT_EQ(mended.report.nonManifoldEdges, 0U);
}

TEST(SlitClosing, ClosesTwoSlitsNearEachOtherEachByItself) {
    const BallShape shape;
    CutMesh cut = cutBall({.ring = 30}, shape);
    cut = cutOpen(cut.mesh, shape, {.ring = 31}); // 3 mm apart: a strip of one row of triangles
    for (const double width : {gap, 2e-3, 4e-3}) {
        const RepairedMesh mended = closed(cut.mesh, width);
        expectSound(mended);
        EXPECT_EQ(mended.report.closedSlitEdges, 2U * 162);
        EXPECT_EQ(mended.mesh.vertices.size(), test::ball().vertices.size());
    }
}

TEST(SlitClosing, DoesNotStitchTheOuterBorderOfASheetToItself) {
    const TriangleMesh sheet = flatSquare(0.1, 20);
    for (const double width : {1e-4, gap, 4e-3, 9e-3}) {
        const RepairedMesh mended = closed(sheet, width);
        EXPECT_EQ(mended.report.closedSlitEdges, 0U) << width;
        EXPECT_EQ(mended.mesh.vertices, repair(soupOf(sheet)).mesh.vertices);
    }
}

TEST(SlitClosing, DoesNotRollUpAStrip) {
    TriangleMesh strip = flatSquare(0.1, 20);
    for (Eigen::Vector3d& vertex : strip.vertices)
        vertex.y() /= 50; // 2 mm wide
    for (const double width : {1e-3, 3e-3, 9e-3}) {
        const RepairedMesh mended = closed(strip, width);
        EXPECT_NEAR(surfaceArea(mended.mesh) / surfaceArea(strip), 1, 1e-9) << width;
        EXPECT_EQ(mended.report.nonManifoldEdges, 0U);
    }
}

TEST(SlitClosing, JoinsTwoHalvesAndThenKeepsThemAsTheLargestPart) {
    const BallShape shape;
    TriangleMesh halves = cutBall({.edges = shape.segments + 1}, shape).mesh;
    RepairOptions options;
    options.keep = KeepParts::Largest;
    options.slitWidth = gap;
    const RepairedMesh mended = repair(soupOf(halves), options);
    expectSound(mended);
    EXPECT_EQ(mended.report.droppedParts, 0U);
}

TEST(SlitClosing, GivesTheSameAgainAndNothingTheSecondTime) {
    CutMesh cut = cutBall({.sway = 5e-4});
    test::thinOut(cut, 3);
    const RepairedMesh once = closed(cut.mesh, gap), again = closed(cut.mesh, gap);
    EXPECT_EQ(once.mesh.vertices, again.mesh.vertices);
    EXPECT_EQ(once.mesh.triangles, again.mesh.triangles);
    const RepairedMesh twice = closed(once.mesh, gap);
    EXPECT_EQ(twice.mesh.triangles, once.mesh.triangles);
    EXPECT_EQ(twice.report.closedSlitEdges, 0U);
}

TEST(SlitClosing, NeverMakesAFaultyEdgeOfRaggedBorders) {
    for (int round = 0; round < roundsOf(10, 200); ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        std::uniform_real_distribution<double> noise(-8e-4, 8e-4);
        CutMesh cut =
            cutBall({.first = static_cast<std::uint32_t>(random() % 120), .gap = 1e-3, .sway = 3e-4});
        test::thinOut(cut, 2 + random() % 4);
        for (const auto* side : {&cut.upper, &cut.lower})
            for (const std::uint32_t vertex : *side)
                for (double& coordinate : cut.mesh.vertices[vertex].reshaped())
                    coordinate += noise(random);
        const RepairedMesh open = repair(soupOf(cut.mesh));
        const RepairedMesh mended = closed(cut.mesh, 2e-3);
        EXPECT_EQ(mended.report.nonManifoldEdges + mended.report.inconsistentEdges, 0U);
        EXPECT_EQ(mended.report.closedSlitEdges + mended.report.boundaryEdges, open.report.boundaryEdges);
        EXPECT_GT(mended.report.closedSlitEdges, open.report.boundaryEdges / 2);
        EXPECT_NEAR(surfaceArea(mended.mesh) / surfaceArea(test::ball()), 1, 0.02);
    }
}

TEST(SlitClosing, RefusesWidthsThatAreNone) {
    for (const double width : {-1e-3, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(), 0.0121, 1.0})
        EXPECT_THROW(closed(cutBall().mesh, width), InvalidModel) << width;
    EXPECT_NO_THROW(closed(cutBall().mesh, 0.0119));
}

TEST(SlitClosing, StopsWhenAskedTo) {
    RepairOptions options;
    options.slitWidth = gap;
    EXPECT_THROW(repair(soupOf(cutBall().mesh), options, [](double) { return false; }), Cancelled);
}

class SlitClosingData : public testing::TestWithParam<const char*> {};

/// What lies near each other on an organ is stitched, and nothing but borders changes.
TEST_P(SlitClosingData, KeepsEveryOrganSound) {
    const auto file = sharedData("meshes") / GetParam();
    ESM_SKIP_WITHOUT(file);
    const PolygonSoup soup = readMeshFile(file);
    const RepairedMesh open = repair(soup);
    const double extent = boundingBox(open.mesh.vertices).sizes().maxCoeff();
    for (const double share : {1e-4, 3e-3, 3e-2}) {
        RepairOptions options;
        options.slitWidth = share * extent;
        const RepairedMesh mended = repair(soup, options);
        EXPECT_LE(mended.report.nonManifoldEdges, open.report.nonManifoldEdges);
        EXPECT_LE(mended.report.boundaryEdges, open.report.boundaryEdges);
        EXPECT_EQ(mended.report.closedSlitEdges + mended.report.boundaryEdges, open.report.boundaryEdges);
        EXPECT_NEAR(surfaceArea(mended.mesh) / surfaceArea(open.mesh), 1, 0.02);
    }
}

INSTANTIATE_TEST_SUITE_P(OpenOrgans, SlitClosingData,
                         testing::Values("VH_F_Fallopian_Tube_L.glb", "VH_F_Uterus.glb", "VH_M_Liver.glb",
                                         "VH_F_Vasculature.glb", "SBU_F_Intestine_Large.glb",
                                         "GCA-VHF-large-intestine.vtk", "GCA-00020-transverse-colon-open.vtk",
                                         "sofa-head-quads-uv.obj", "sofa-skull-and-teeth-coarse.obj"));

} // namespace
} // namespace esm

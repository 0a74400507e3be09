#include "core/geometry/repair.h"
#include "core/support/errors.h"
#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <random>

namespace esm {
namespace {

using test::append;
using test::cubeSoup;
using test::soupOf;
using test::torus;
using testing::HasSubstr;

std::string messageOf(const PolygonSoup& soup, const RepairOptions& options = {}) {
    try {
        repair(soup, options);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return {};
}

TEST(Repair, MakesAClosedMeshOfACubeOfSeparateSquares) {
    const RepairedMesh cube = repair(cubeSoup(2));
    EXPECT_EQ(cube.mesh.vertices.size(), 8U);
    EXPECT_EQ(cube.mesh.triangles.size(), 12U);
    EXPECT_EQ(cube.report.mergedVertices, 16U);
    EXPECT_EQ(cube.report.splitPolygons, 6U);
    EXPECT_EQ(cube.report.flippedTriangles, 0U);
    EXPECT_EQ(cube.report.components, 1U);
    EXPECT_TRUE(cube.report.isClosed());
    EXPECT_DOUBLE_EQ(enclosedVolume(cube.mesh), 8);
    EXPECT_DOUBLE_EQ(surfaceArea(cube.mesh), 24);
    EXPECT_TRUE(cube.report.warnings.empty());
}

TEST(Repair, NumbersVerticesInTheOrderOfFirstUse) {
    PolygonSoup soup;
    soup.vertices = {{9, 9, 9}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    soup.polygons = {{3, 2, 1}, {4, 2, 5}};
    const RepairedMesh repaired = repair(soup);
    const std::vector<Eigen::Vector3d> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(repaired.mesh.vertices, expected);
    EXPECT_EQ(repaired.report.mergedVertices, 1U);
    EXPECT_EQ(repaired.report.unusedVertices, 1U);
}

TEST(Repair, NumbersVerticesTheSameWayWhenTrianglesAreTurned) {
    PolygonSoup turned = soupOf(torus());
    for (auto& polygon : turned.polygons)
        std::reverse(polygon.begin() + 1, polygon.end());
    const RepairedMesh repaired = repair(turned);
    EXPECT_EQ(repaired.report.flippedTriangles, turned.polygons.size());
    std::vector<std::uint32_t> firstUse;
    std::vector<bool> seen(turned.vertices.size(), false);
    for (const auto& polygon : turned.polygons)
        for (const std::uint32_t vertex : polygon) {
            if (!seen[vertex]) firstUse.push_back(vertex);
            seen[vertex] = true;
        }
    for (std::size_t i = 0; i < firstUse.size(); ++i)
        EXPECT_EQ(repaired.mesh.vertices[i], turned.vertices[firstUse[i]]);
}

TEST(Repair, ChangesNothingTheSecondTime) {
    PolygonSoup soup = cubeSoup();
    append(soup, soupOf(torus()));
    const RepairedMesh once = repair(soup);
    const RepairedMesh twice = repair(soupOf(once.mesh));
    EXPECT_EQ(twice.mesh.vertices, once.mesh.vertices);
    EXPECT_EQ(twice.mesh.triangles, once.mesh.triangles);
    EXPECT_EQ(twice.report.mergedVertices + twice.report.flippedTriangles + twice.report.removedTriangles(),
              0U);
}

TEST(Repair, RestoresTheOrientationOfAClosedMeshAfterRandomFlips) {
    const TriangleMesh mesh = torus();
    const double volume = enclosedVolume(mesh);
    std::mt19937 random(7);
    for (int trial = 0; trial < 20; ++trial) {
        PolygonSoup soup = soupOf(mesh);
        std::size_t flipped = 0;
        for (auto& polygon : soup.polygons)
            if (random() % 100 < static_cast<unsigned>(5 * trial)) {
                std::swap(polygon[0], polygon[1]);
                ++flipped;
            }
        const RepairedMesh repaired = repair(soup);
        EXPECT_EQ(repaired.report.flippedTriangles, flipped);
        EXPECT_EQ(repaired.report.inconsistentEdges, 0U);
        EXPECT_NEAR(enclosedVolume(repaired.mesh), volume, 1e-12);
    }
}

TEST(Repair, KeepsTheDirectionOfMostTrianglesOfAnOpenSurface) {
    PolygonSoup soup = soupOf(torus());
    soup.polygons.resize(soup.polygons.size() / 2);
    const std::vector<std::vector<std::uint32_t>> original = soup.polygons;
    for (std::size_t i = 0; i < 20; ++i)
        std::swap(soup.polygons[i][0], soup.polygons[i][1]);
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.flippedTriangles, 20U);
    EXPECT_EQ(repaired.report.inconsistentEdges, 0U);
    EXPECT_FALSE(repaired.report.isClosed());
    EXPECT_EQ(repaired.report.boundaryEdges, 2U * 12U);
}

TEST(Repair, TurnsEveryClosedPartOutwards) {
    PolygonSoup soup = cubeSoup();
    PolygonSoup inwards = cubeSoup(1, {5, 0, 0});
    for (auto& polygon : inwards.polygons)
        std::reverse(polygon.begin(), polygon.end());
    append(soup, inwards);
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.flippedTriangles, 12U);
    EXPECT_EQ(repaired.report.components, 2U);
    EXPECT_NEAR(enclosedVolume(repaired.mesh), 2, 1e-12);
}

TEST(Repair, TurnsClosedShellsThatTouchInAnEdgeOutwards) {
    PolygonSoup soup = cubeSoup();
    append(soup, cubeSoup(1, {1, 1, 0}));
    for (auto& polygon : soup.polygons)
        std::reverse(polygon.begin(), polygon.end());
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.nonManifoldEdges, 1U);
    EXPECT_EQ(repaired.report.components, 1U);
    EXPECT_EQ(repaired.report.flippedTriangles, 24U);
    EXPECT_NEAR(enclosedVolume(repaired.mesh), 2, 1e-12);
}

TEST(Repair, ReportsAMoebiusStripAsInconsistent) {
    PolygonSoup soup;
    constexpr std::uint32_t count = 16;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / count;
        for (const double side : {-0.3, 0.3}) {
            const double r = 1 + side * std::cos(angle / 2);
            soup.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2));
        }
        const bool last = i + 1 == count;
        const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        soup.polygons.push_back({a, b, d});
        soup.polygons.push_back({a, d, c});
    }
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.inconsistentEdges, 1U);
    EXPECT_EQ(repaired.report.boundaryEdges, 2U * count);
    EXPECT_EQ(repaired.report.nonManifoldEdges, 0U);
}

TEST(Repair, DropsDuplicateAndDegenerateTrianglesAndCountsThem) {
    PolygonSoup soup = cubeSoup();
    soup.polygons.push_back({2, 3, 0, 1}); // the first square again, turned by two corners
    soup.polygons.push_back({0, 0, 1});    // equal corners
    soup.polygons.push_back({0, 8, 1});    // equal after welding
    const auto collinear = static_cast<std::uint32_t>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), {{7, 0, 0}, {7, 1, 1}, {7, 3, 3}});
    soup.polygons.push_back({collinear, collinear + 1, collinear + 2});
    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.duplicateTriangles, 2U);
    EXPECT_EQ(repaired.report.degenerateTriangles, 3U);
    EXPECT_EQ(repaired.report.unusedVertices, 3U);
    EXPECT_EQ(repaired.report.nonManifoldEdgesBefore, 5U);
    EXPECT_EQ(repaired.report.nonManifoldEdges, 0U);
    EXPECT_TRUE(repaired.report.isClosed());
    EXPECT_EQ(repaired.mesh.triangles.size(), 12U);
    EXPECT_THAT(repaired.report.warnings, testing::Contains(HasSubstr("2 duplicate triangles")));
}

TEST(Repair, WeldsWithinADistanceOnlyWhatLiesWithinIt) {
    PolygonSoup soup = cubeSoup(1);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> noise(-0.004, 0.004);
    for (Eigen::Vector3d& vertex : soup.vertices)
        for (double& coordinate : vertex.reshaped())
            coordinate += noise(random);
    EXPECT_EQ(repair(soup).report.boundaryEdges, 24U);
    RepairOptions options;
    options.weldDistance = 0.02;
    const RepairedMesh repaired = repair(soup, options);
    EXPECT_EQ(repaired.mesh.vertices.size(), 8U);
    EXPECT_TRUE(repaired.report.isClosed());
    EXPECT_NEAR(enclosedVolume(repaired.mesh), 1, 0.03);
}

TEST(Repair, KeepsTheLargestPart) {
    PolygonSoup soup = cubeSoup(100);
    append(soup, soupOf(torus()));
    append(soup, cubeSoup(1, {300, 0, 0}));
    RepairOptions options;
    options.keep = KeepParts::Largest;
    const RepairedMesh repaired = repair(soup, options);
    EXPECT_EQ(repaired.report.components, 1U);
    EXPECT_EQ(repaired.report.droppedParts, 2U);
    EXPECT_EQ(repaired.mesh.vertices, repair(soupOf(torus())).mesh.vertices);
}

TEST(Repair, SplitsAConcavePolygonIntoTheSameArea) {
    const std::vector<std::vector<Eigen::Vector2d>> shapes{
        {{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}, // a U
        {{0, 0}, {2, 1}, {4, 0}, {2, 4}},                                 // a dart
        {{0, 0},
         {6, 0},
         {6, 6},
         {0, 6},
         {0, 2},
         {4, 2},
         {4, 4},
         {2, 4},
         {2, 3}, // a spiral
         {3, 3},
         {3, 2.5},
         {1, 2.5},
         {1, 5},
         {5, 5},
         {5, 1},
         {0, 1}}};
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
    for (const auto& shape : shapes) {
        double area = 0;
        PolygonSoup soup;
        soup.polygons.emplace_back();
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const Eigen::Vector2d &a = shape[i], &b = shape[(i + 1) % shape.size()];
            area += (a.x() * b.y() - b.x() * a.y()) / 2;
            soup.polygons[0].push_back(static_cast<std::uint32_t>(i));
            soup.vertices.emplace_back(tilt * Eigen::Vector3d(a.x(), a.y(), 5));
        }
        for (std::size_t start = 0; start < shape.size(); ++start) {
            std::rotate(soup.polygons[0].begin(), soup.polygons[0].begin() + 1, soup.polygons[0].end());
            const RepairedMesh repaired = repair(soup);
            EXPECT_EQ(repaired.mesh.triangles.size(), shape.size() - 2);
            EXPECT_NEAR(surfaceArea(repaired.mesh), area, 1e-12);
        }
    }
}

TEST(Repair, ListsEverythingThatIsWrongAtOnce) {
    PolygonSoup soup = cubeSoup();
    soup.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    soup.vertices[7].y() = 1e300;
    soup.polygons[1] = {0, 1};
    soup.polygons[4][2] = 99;
    RepairOptions options;
    options.weldDistance = -1;
    try {
        repair(soup, options);
        FAIL() << "accepted";
    } catch (const InvalidModel& error) {
        EXPECT_THAT(error.problems(),
                    testing::ElementsAre(HasSubstr("weld distance"), HasSubstr("mesh point 3, 7"),
                                         HasSubstr("face 1"), HasSubstr("face 4")));
    }
}

/// Six points and ten triangles of which each edge has two: a closed surface with one side only.
TEST(Repair, DoesNotCallAProjectivePlaneClosed) {
    PolygonSoup soup;
    soup.vertices = {{0, 0, 0}, {1, 0, 0.2}, {0.3, 1, 0}, {0.2, 0.1, 1}, {-1, 0.4, 0.3}, {0.1, -0.8, -0.9}};
    soup.polygons = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                     {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    const RepairReport report = repair(soup).report;
    EXPECT_EQ(report.boundaryEdges, 0U);
    EXPECT_GT(report.inconsistentEdges, 0U);
    EXPECT_FALSE(report.isClosed());
}

TEST(Repair, RefusesWhatIsNoMesh) {
    PolygonSoup nan = cubeSoup();
    nan.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(messageOf(nan), HasSubstr("mesh point 3"));
    PolygonSoup infinite = cubeSoup();
    infinite.vertices[5].x() = std::numeric_limits<double>::infinity();
    EXPECT_THAT(messageOf(infinite), HasSubstr("mesh point 5"));
    PolygonSoup missing = cubeSoup();
    missing.polygons[2][1] = 24;
    EXPECT_THAT(messageOf(missing), testing::AllOf(HasSubstr("face 2"), HasSubstr("the 24 there are")));
    PolygonSoup line = cubeSoup();
    line.polygons[1] = {0, 1};
    EXPECT_THAT(messageOf(line), HasSubstr("face 1"));
    EXPECT_THAT(messageOf({}), HasSubstr("no triangle"));
    RepairOptions everything;
    everything.weldDistance = 1000;
    EXPECT_THAT(messageOf(cubeSoup(), everything), HasSubstr("no triangle"));
    RepairOptions negative;
    negative.weldDistance = -1;
    EXPECT_THAT(messageOf(cubeSoup(), negative), HasSubstr("weld distance"));
}

} // namespace
} // namespace esm

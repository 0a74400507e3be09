#include "core/surface/simplify.h"

#include "core/geometry/adjacency.h"
#include "core/support/errors.h"
#include "tests/support/test_meshes.h"
#include "tests/support/test_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {
namespace {

using test::torus;
using testing::HasSubstr;

TriangleMesh meshOf(const TriangleMesh& finer, const SimplifiedMesh& simplified) {
    TriangleMesh mesh{{}, simplified.triangles};
    for (const std::uint32_t vertex : simplified.vertices)
        mesh.vertices.push_back(finer.vertices[vertex]);
    return mesh;
}

std::string refusal(const TriangleMesh& mesh, std::size_t vertexCount) {
    try {
        simplify(mesh, vertexCount);
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return {};
}

/// Beside the first mesh.
void append(TriangleMesh& mesh, TriangleMesh other, const Eigen::Vector3d& offset) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Eigen::Vector3d& vertex : other.vertices)
        mesh.vertices.emplace_back(vertex + offset);
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

double borderLength(const TriangleMesh& mesh) {
    const auto sides = sidesByEdge(mesh.triangles);
    double length = 0;
    forEachEdge(sides, [&](auto first, auto last) {
        if (last - first == 1)
            length += (mesh.vertices[first->edge.first] - mesh.vertices[first->edge.second]).norm();
    });
    return length;
}

TEST(Simplify, KeepsAsManyVerticesAsAskedForAndTheShape) {
    const TriangleMesh finer = lumpySurface(40, 80);
    for (const std::size_t count : {4U, 60U, 500U, 1501U, 3000U}) {
        const SimplifiedMesh simplified = simplify(finer, count);
        EXPECT_EQ(simplified.vertices.size(), count);
        EXPECT_TRUE(std::is_sorted(simplified.vertices.begin(), simplified.vertices.end()));
        const TriangleMesh coarse = meshOf(finer, simplified);
        EXPECT_TRUE(countEdges(sidesByEdge(coarse.triangles)).isClosed()) << count;
        if (count >= 500) {
            EXPECT_NEAR(enclosedVolume(coarse) / enclosedVolume(finer), 1, 0.04) << count;
        }
    }
}

/// Tissue bends anywhere, not only where it is bent at rest.
TEST(Simplify, LeavesNoPartOfASmoothSurfaceWithoutVertices) {
    TriangleMesh tube;
    for (int ring = 0; ring <= 120; ++ring)
        for (int i = 0; i < 24; ++i)
            tube.vertices.emplace_back(0.3 * ring / 120, 0.02 * std::cos(2 * M_PI * i / 24),
                                       0.02 * std::sin(2 * M_PI * i / 24));
    for (std::uint32_t ring = 0; ring < 120; ++ring)
        for (std::uint32_t i = 0; i < 24; ++i) {
            const std::uint32_t a = 24 * ring + i, b = 24 * ring + (i + 1) % 24;
            tube.triangles.push_back({a, b, b + 24});
            tube.triangles.push_back({a, b + 24, a + 24});
        }
    const TriangleMesh coarse = meshOf(tube, simplify(tube, 300));
    double longest = 0;
    for (const Edge& edge : uniqueEdges(coarse.triangles))
        longest = std::max(longest, (coarse.vertices[edge.first] - coarse.vertices[edge.second]).norm());
    // An even mesh has edges of 12 mm; the straight tube alone would need none shorter than itself.
    EXPECT_LT(longest, 0.06);
}

TEST(Simplify, HasNoFlatFolds) {
    for (const std::size_t count : {50U, 200U, 700U}) {
        const SimplifiedMesh simplified = simplify(test::torus(60, 30, 1, 0.1), count);
        std::set<std::set<std::uint32_t>> corners;
        for (const Triangle& triangle : simplified.triangles)
            EXPECT_TRUE(corners.insert({triangle.begin(), triangle.end()}).second) << count;
    }
}

TEST(Simplify, KeepsEverythingWhereNothingIsToGo) {
    const TriangleMesh mesh = torus();
    const SimplifiedMesh whole = simplify(mesh, mesh.vertices.size());
    EXPECT_EQ(whole.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(whole.triangles, mesh.triangles);
}

TEST(Simplify, KeepsBorders) {
    const TriangleMesh finer = flatSquare(0.1, 30);
    const TriangleMesh coarse = meshOf(finer, simplify(finer, 60));
    EXPECT_EQ(coarse.vertices.size(), 60U);
    EXPECT_NEAR(borderLength(coarse), 0.4, 1e-6);
    EXPECT_NEAR(surfaceArea(coarse), 0.01, 5e-4);
}

TEST(Simplify, LeavesSomethingOfEveryPart) {
    TriangleMesh parts = lumpySurface(30, 60);
    for (int i = 1; i <= 20; ++i)
        append(parts, torus(6, 4, 0.002, 0.0006), {0.3, 0.01 * i, 0});
    const SimplifiedMesh simplified = simplify(parts, 300);
    EXPECT_LT(simplified.vertices.size(), 500U);
    EXPECT_EQ(connectedParts(simplified.triangles, simplified.vertices.size()).count, 21U);
    EXPECT_EQ(connectedParts(simplify(parts, 4).triangles, parts.vertices.size()).count, 21U);
}

TEST(Simplify, IsTheSameEveryTimeAndAnywhereInSpace) {
    const TriangleMesh mesh = lumpySurface(30, 60);
    TriangleMesh away;
    append(away, mesh, {1000, -2000, 500});
    const SimplifiedMesh first = simplify(mesh, 400);
    EXPECT_EQ(simplify(mesh, 400).triangles, first.triangles);
    EXPECT_NEAR(enclosedVolume(meshOf(away, simplify(away, 400))) / enclosedVolume(mesh), 1, 0.04);
}

TEST(Simplify, SaysHowManyThereMayBe) {
    const TriangleMesh mesh = torus();
    EXPECT_THAT(refusal(mesh, 3), HasSubstr("4 to 288 nodes, not by 3"));
    EXPECT_THAT(refusal(mesh, 289), HasSubstr("4 to 288 nodes, not by 289"));
}

} // namespace
} // namespace esm

#include "core/solid/self_intersections.h"

#include "tests/support/solid_surfaces.h"
#include "tests/support/steady_progress.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

TEST(SelfIntersections, AreNoneWhereASurfaceOnlyTouchesItself) {
    EXPECT_EQ(selfIntersectionsOf(lumpySurface(30, 60)).pairs, 0U);
    EXPECT_EQ(selfIntersectionsOf(test::torus()).pairs, 0U);
    EXPECT_EQ(selfIntersectionsOf({}).pairs, 0U);
    // Two blocks that share a face's plane.
    TriangleMesh blocks = test::block({0, 0, 0}, {1, 1, 1});
    test::append(blocks, test::block({1, 0, 0}, {2, 1, 1}));
    EXPECT_EQ(selfIntersectionsOf(blocks).pairs, 0U);
}

TEST(SelfIntersections, AreCountedByPairs) {
    // A needle through one triangle: two of its sides pierce it, the third triangle's edge as well.
    TriangleMesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1.2, 1, 1}, {1, 1.2, 1}},
                      {{0, 1, 2}, {3, 4, 5}}};
    const SelfIntersections found = selfIntersectionsOf(mesh);
    EXPECT_EQ(found.pairs, 1U);
    EXPECT_NEAR(found.first.z(), 0, 1e-12);
    EXPECT_NEAR(found.first.y(), 1, 0.2);
}

/// Pairs of an edge and a triangle, all tried, of two surfaces that share no vertex.
bool doesPierce(const TriangleMesh& mesh, const Triangle& edges, const Triangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d from = mesh.vertices[edges[i]], way = mesh.vertices[edges[(i + 1) % 3]] - from;
        Eigen::Matrix3d system;
        system << mesh.vertices[triangle[1]] - mesh.vertices[triangle[0]],
            mesh.vertices[triangle[2]] - mesh.vertices[triangle[0]], -way;
        const Eigen::Vector3d s = system.inverse() * (from - mesh.vertices[triangle[0]]);
        if (s[0] > 0 && s[1] > 0 && s[0] + s[1] < 1 && s[2] > 0 && s[2] < 1) return true;
    }
    return false;
}

TEST(SelfIntersections, AreThoseThatTryingAllPairsFinds) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0}, 12);
    const std::size_t ofFirst = mesh.triangles.size();
    test::append(mesh, test::ball(0.7, {0.9, 0.13, 0.21}, 12));
    std::size_t expected = 0;
    for (std::size_t i = 0; i < ofFirst; ++i)
        for (std::size_t j = ofFirst; j < mesh.triangles.size(); ++j)
            expected += doesPierce(mesh, mesh.triangles[i], mesh.triangles[j]) ||
                        doesPierce(mesh, mesh.triangles[j], mesh.triangles[i]);
    EXPECT_GT(expected, 20U);
    EXPECT_EQ(selfIntersectionsOf(mesh).pairs, expected);
}

// One long triangle lies in the boxes of none but those that it meets, however small the others are.
TEST(SelfIntersections, AreFoundBesideATriangleThatIsFarLongerThanAllOthers) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0}, 60);
    EXPECT_EQ(selfIntersectionsOf(mesh).pairs, 0U);
    test::append(mesh, {{{-100, -77, -61}, {100, 77, 61}, {100, 77, 61.01}}, {{0, 1, 2}}});
    EXPECT_GE(selfIntersectionsOf(mesh).pairs, 2U);
    EXPECT_LE(selfIntersectionsOf(mesh).pairs, 8U);
}

TEST(SelfIntersections, AreSoughtWithProgress) {
    const TriangleMesh mesh = test::ball(1, {0, 0, 0}, 60);
    test::expectSteadyProgress([&](const Progress& progress) { selfIntersectionsOf(mesh, progress); });
}

} // namespace
} // namespace esm

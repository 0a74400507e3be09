#include "core/geometry/adjacency.h"
#include "core/geometry/disjoint_sets.h"
#include "tests/support/test_meshes.h"

#include <gmock/gmock.h>

using namespace esm;
using testing::ElementsAre;

namespace {

const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

} // namespace

TEST(Sides, LieTogetherByEdge) {
    const auto sides = sidesByEdge(tetrahedron);
    ASSERT_EQ(sides.size(), 12);
    std::size_t edges = 0;
    forEachEdge(sides, [&](auto first, auto last) {
        ++edges;
        ASSERT_EQ(last - first, 2);
        EXPECT_EQ(first->edge, (first + 1)->edge);
        EXPECT_LT(first->edge.first, first->edge.second);
        EXPECT_LT(first->triangle, (first + 1)->triangle);
        EXPECT_NE(first->forward, (first + 1)->forward);
    });
    EXPECT_EQ(edges, 6);
}

TEST(EdgeCounts, TellBordersWallsAndDisagreement) {
    const auto counts = [](std::vector<Triangle> triangles) { return countEdges(sidesByEdge(triangles)); };
    EXPECT_TRUE(counts(tetrahedron).isClosed());
    EXPECT_TRUE(counts(test::torus().triangles).isClosed());

    std::vector<Triangle> open = tetrahedron;
    open.pop_back();
    EXPECT_EQ(counts(open).boundary, 3);
    EXPECT_FALSE(counts(open).isClosed());

    std::vector<Triangle> turned = tetrahedron;
    std::swap(turned[2][0], turned[2][1]);
    EXPECT_EQ(counts(turned).inconsistent, 3);
    EXPECT_FALSE(counts(turned).isClosed());

    std::vector<Triangle> walled = tetrahedron;
    walled.push_back({0, 1, 4});
    EXPECT_EQ(counts(walled).nonManifold, 1);
    EXPECT_EQ(counts(walled).boundary, 2);
    EXPECT_EQ(counts({}).boundary, 0);
}

TEST(Parts, AreNumberedByTheirFirstTriangle) {
    const Parts parts = connectedParts({{5, 6, 7}, {0, 1, 2}, {7, 8, 9}, {2, 3, 4}, {10, 11, 12}}, 13);
    EXPECT_EQ(parts.count, 3);
    EXPECT_THAT(parts.ofTriangle, ElementsAre(0, 1, 0, 1, 2));
    EXPECT_EQ(connectedParts({}, 4).count, 0);
}

TEST(DisjointSets, AreNamedByTheirLowestNumber) {
    DisjointSets sets(8);
    EXPECT_EQ(sets.lowest(5), 5);
    sets.join(5, 7);
    sets.join(3, 7);
    sets.join(1, 2);
    sets.join(3, 5);
    for (const std::uint32_t number : {3U, 5U, 7U})
        EXPECT_EQ(sets.lowest(number), 3);
    EXPECT_EQ(sets.lowest(2), 1);
    EXPECT_EQ(sets.lowest(0), 0);
    sets.join(7, 1);
    for (const std::uint32_t number : {1U, 2U, 3U, 5U, 7U})
        EXPECT_EQ(sets.lowest(number), 1);
}

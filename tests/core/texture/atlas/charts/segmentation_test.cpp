#include "core/texture/atlas/charts/segmentation.h"

#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace esm {
namespace {

DualGraph graphOf(const TriangleMesh& mesh) {
    return dualGraph(mesh, std::vector<bool>(mesh.triangles.size(), true));
}

std::size_t reachedFromFirst(const DualGraph& graph) {
    std::vector<bool> isReached(graph.size(), false);
    std::vector<std::uint32_t> ways{0};
    isReached[0] = true;
    std::size_t count = 0;
    for (; !ways.empty(); ++count) {
        const std::uint32_t triangle = ways.back();
        ways.pop_back();
        for (const std::uint32_t next : graph.across[triangle]) {
            if (next == noIndex || isReached[next]) continue;
            isReached[next] = true;
            ways.push_back(next);
        }
    }
    return count;
}

template<typename Sets> void expectEveryTriangleOnceInJoinedSets(const DualGraph& graph, const Sets& sets) {
    std::vector<std::uint32_t> all;
    for (const TriangleSet& set : sets) {
        ASSERT_FALSE(set.empty());
        EXPECT_TRUE(std::is_sorted(set.begin(), set.end()));
        EXPECT_EQ(reachedFromFirst(partOf(graph, set)), set.size());
        all.insert(all.end(), set.begin(), set.end());
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), graph.size());
    EXPECT_TRUE(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST(Segmentation, GivesEveryTriangleOneJoinedPiece) {
    const DualGraph graph = graphOf(lumpySurface(40, 60));
    const std::vector<TriangleSet> pieces = segments(graph, {});
    expectEveryTriangleOnceInJoinedSets(graph, pieces);
    EXPECT_GT(pieces.size(), 5U) << "it turns all around";
    EXPECT_LT(pieces.size(), 60U) << "of 4 680 triangles";
    EXPECT_EQ(segments(graph, {}), pieces);
}

TEST(Segmentation, HalvesAnythingDownToTwoTriangles) {
    for (const TriangleMesh& mesh : {lumpySurface(12, 16), flatSquare(0.1, 4), flatSquare(0.1, 1)}) {
        const DualGraph graph = graphOf(mesh);
        expectEveryTriangleOnceInJoinedSets(graph, halves(graph));
    }
    TriangleMesh folded = flatSquare(0.1, 1);
    folded.vertices[2] = folded.vertices[1]; // both centres are one point
    expectEveryTriangleOnceInJoinedSets(graphOf(folded), halves(graphOf(folded)));
}

TEST(Segmentation, LeavesOutWhatHasNoArea) {
    const TriangleMesh mesh = flatSquare(0.1, 2);
    std::vector<bool> hasArea(mesh.triangles.size(), true);
    hasArea[3] = false;
    for (const TriangleSet& piece : segments(dualGraph(mesh, hasArea), {}))
        EXPECT_EQ(std::count(piece.begin(), piece.end(), 3U), 0);
}

} // namespace
} // namespace esm

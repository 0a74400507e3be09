#include "core/geometry/sorted_by_vertex.h"
#include "core/geometry/triangle_mesh.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

using namespace esm;
using testing::ElementsAre;

namespace {

/// Many of few vertices, so that a good part is repeated, and a vertex that most share.
std::vector<Edge> manyEdges() {
    std::mt19937 random(7);
    std::vector<Edge> edges;
    for (int i = 0; i < 5000; ++i) {
        const auto one = static_cast<std::uint32_t>(random() % 60),
                   other = static_cast<std::uint32_t>(random() % 60);
        edges.push_back(i % 3 == 0 ? Edge{17, one} : Edge{one, other});
    }
    return edges;
}

} // namespace

TEST(SortedByVertex, AgreesWithASortOfAll) {
    std::vector<Edge> edges = manyEdges();
    const auto isLess = [](const Edge& a, const Edge& b) { return a.second > b.second; };
    const std::vector<Edge> sorted = sortedByVertex(
        edges, [](const Edge& edge) { return edge.first; }, isLess);
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return a.first != b.first ? a.first < b.first : a.second > b.second;
    });
    EXPECT_EQ(sorted, edges);
}

TEST(SortedByVertex, TakesNothing) {
    const std::vector<Edge> nothing;
    EXPECT_TRUE(sortedByVertex(
                    nothing, [](const Edge& edge) { return edge.first; }, std::less<Edge>())
                    .empty());
}

TEST(Repeats, AreAllButTheFirstOfEqualOnes) {
    EXPECT_THAT(
        repeats(std::vector<Triangle>{{3, 4, 5}, {0, 1, 2}, {3, 4, 6}, {3, 4, 5}, {0, 1, 2}, {3, 4, 5}}),
        ElementsAre(false, false, false, true, true, true));
    const std::vector<Edge> edges = manyEdges();
    const std::vector<bool> isRepeated = repeats(edges);
    std::set<Edge> seen;
    for (std::size_t i = 0; i < edges.size(); ++i)
        EXPECT_EQ(isRepeated[i], !seen.insert(edges[i]).second) << i;
    EXPECT_TRUE(repeats(std::vector<Edge>()).empty());
}

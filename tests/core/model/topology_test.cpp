#include "core/model/topology.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(NodeMap, GivesNewNodesTheMeanOfTheirSources) {
    NodeMap map = NodeMap::identity(2);
    map.add({{1, 0.25}, {0, 0.75}});
    EXPECT_EQ(map.size(), 3U);
    EXPECT_THAT(map.problems(2, 3), IsEmpty());
    const Eigen::Vector3d first(1, -0.0, 3), second(5, 2, -1);
    const std::vector<Eigen::Vector3d> mapped = map.mapped({first, second});
    ASSERT_EQ(mapped.size(), 3U);
    EXPECT_EQ(mapped[0], first);
    EXPECT_TRUE(std::signbit(mapped[0].y()));
    EXPECT_EQ(mapped[1], second);
    EXPECT_EQ(mapped[2], Eigen::Vector3d(2, 0.5, 2));
}

TEST(NodeMap, TellsWhatIsNoMap) {
    NodeMap map = NodeMap::identity(3);
    EXPECT_THAT(map.problems(3, 4), ElementsAre(HasSubstr("3 of 4 nodes")));
    EXPECT_THAT(map.problems(2, 3), ElementsAre(HasSubstr("(node 2)")));
    map.add({{0, 0.5}, {1, 0.6}});
    EXPECT_THAT(map.problems(3, 4), ElementsAre(HasSubstr("(node 3)")));
}

TEST(Topology, ThatWasAuthoredComesFromItself) {
    const auto mesh =
        std::make_shared<const TriangleMesh>(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    const Topology topology =
        authoredTopology(mesh, std::make_shared<const SpringNetwork>(networkFromMesh(*mesh)));
    EXPECT_EQ(topology.surface, mesh);
    EXPECT_THAT(topology.origin, ElementsAre(0, 1, 2));
}

} // namespace
} // namespace esm

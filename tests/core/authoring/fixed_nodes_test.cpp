#include "core/authoring/fixed_nodes.h"

#include "core/samples/samples.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;
using Eigen::Vector3d;
using Nodes = std::vector<std::uint32_t>;

namespace {

class FixedNodesTest : public testing::Test {
protected:
    FixedNodesTest() { project.scene.fixed.clear(); }
    Nodes fixed() const { return fixedNodesOf(*project.network, project.scene); }
    const std::vector<Vector3d>& nodes() const { return project.network->restPositions; }

    Project project = makeSample("liver");
};

} // namespace

TEST_F(FixedNodesTest, LieAlongThePathAndNowhereElse) {
    const Vector3d from = nodes()[100], to = from + Vector3d(0.03, 0.01, 0), end = to + Vector3d(0, 0.02, 0);
    const Nodes found = nodesAlong(*project.network, {from, to, end}, 0.008);
    EXPECT_FALSE(found.empty());
    for (std::uint32_t node = 0; node < nodes().size(); ++node) {
        // By many points of the path in place of its lines.
        double nearest = 1;
        for (int i = 0; i <= 2000; ++i) {
            const double share = i / 2000.0;
            nearest = std::min({nearest, (from + share * (to - from) - nodes()[node]).norm(),
                                (to + share * (end - to) - nodes()[node]).norm()});
        }
        if (std::abs(nearest - 0.008) < 1e-5) continue;
        EXPECT_EQ(nearest < 0.008, std::binary_search(found.begin(), found.end(), node)) << node;
    }
    EXPECT_EQ(nodesAlong(*project.network, {from}, 1e-6), Nodes{100});
    EXPECT_EQ(nodesAlong(*project.network, {}, 0.01), Nodes());
}

TEST_F(FixedNodesTest, AreFixedOnceAndFreedAgain) {
    fixNodes(project, {7, 3, 5});
    fixNodes(project, {5, 9});
    EXPECT_EQ(fixed(), (Nodes{3, 5, 7, 9}));
    EXPECT_EQ(project.scene.fixed.size(), 1U) << "they are told as one list";
    freeNodes(project, {5, 3, 1000});
    EXPECT_EQ(fixed(), (Nodes{7, 9}));
    freeNodes(project, {7, 9});
    EXPECT_TRUE(project.scene.fixed.empty());
}

TEST_F(FixedNodesTest, AnEllipsoidThatHoldsThemStaysUntilOneOfItsOwnIsFreed) {
    Ellipsoid ellipsoid;
    ellipsoid.centre = nodes()[50];
    ellipsoid.radii = Vector3d::Constant(0.02);
    project.scene.fixed.push_back({{}, ellipsoid});
    const Nodes inside = fixed();
    ASSERT_GT(inside.size(), 2U);
    const auto outside =
        static_cast<std::uint32_t>(std::find_if(nodes().begin(), nodes().end(),
                                                [&](const Vector3d& n) { return !contains(ellipsoid, n); }) -
                                   nodes().begin());
    fixNodes(project, {outside});
    freeNodes(project, {outside});
    ASSERT_EQ(project.scene.fixed.size(), 1U);
    EXPECT_TRUE(project.scene.fixed[0].ellipsoid);
    const Project before = project;
    fixNodes(project, inside);
    EXPECT_EQ(project, before) << "all are held already";
    freeNodes(project, {inside[1]});
    Nodes left = inside;
    left.erase(left.begin() + 1);
    EXPECT_EQ(fixed(), left);
}

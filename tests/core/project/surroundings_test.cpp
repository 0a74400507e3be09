#include "core/project/surroundings.h"

#include "core/project/detail_change.h"
#include "tests/support/solid_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace esm {
namespace {

const Detail filled{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::BodyCentred, 0.012}};

Project lump(const Detail& detail) {
    TriangleMesh mesh = lumpySurface(30, 60);
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= 0.5 / boundingBox(mesh.vertices).diagonal().norm();
    return makeProject("lump", {mesh, {}}, 0.5, detail);
}

double strengthOf(const Project& project) {
    double sum = 0;
    for (const Tether& tether : evaluateModel(project).tethers)
        sum += tether.springConstant;
    return sum;
}

TEST(Surroundings, HoldABodyAtItsSurfaceAlone) {
    const Project solid = lump(filled);
    const std::vector<std::uint32_t> atSurface = surfaceNodes(*solid.network->lattice);
    EXPECT_LT(atSurface.size(), solid.network->restPositions.size());
    const std::set<std::uint32_t> surface(atSurface.begin(), atSurface.end());
    const std::vector<Tether> tethers = evaluateModel(solid).tethers;
    ASSERT_FALSE(tethers.empty());
    for (const Tether& tether : tethers)
        EXPECT_EQ(surface.count(tether.node), 1U) << tether.node;
}

TEST(Surroundings, HoldAWallAtItsOuterSideAlone) {
    const Detail wall{Detail::Kind::Filled, 0, LatticeFilling{LatticeKind::Prisms, 0, 0.004, 2}};
    const Project hollow = lump({}), walled = lump(wall);
    const std::size_t vertices = walled.mesh->vertices.size();
    EXPECT_EQ(outerNodes(*walled.network).size(), vertices);
    for (const Tether& tether : evaluateModel(walled).tethers)
        EXPECT_EQ(walled.network->restPositions[tether.node], walled.mesh->vertices[tether.node]);
    EXPECT_NEAR(strengthOf(walled) / strengthOf(hollow), 1, 0.05);
    EXPECT_NEAR(strengthOf(withDetail(hollow, wall)) / strengthOf(hollow), 1, 0.05);
}

TEST(Surroundings, HoldABodyAsStronglyAsItsSurface) {
    const Project hollow = lump({}), solid = lump(filled);
    EXPECT_NEAR(strengthOf(solid) / strengthOf(hollow), 1, 0.05);
    EXPECT_NEAR(strengthOf(withDetail(hollow, filled)) / strengthOf(hollow), 1, 0.05);
    EXPECT_NEAR(strengthOf(withDetail(solid, {})) / strengthOf(hollow), 1, 0.05);
}

TEST(Surroundings, HoldAsStronglyWhateverTheNumberOfNodes) {
    const double every = strengthOf(lump({Detail::Kind::EveryVertex, 0, {}, true}));
    for (const std::size_t nodes : {900U, 300U, 100U})
        EXPECT_NEAR(strengthOf(lump({Detail::Kind::Nodes, nodes, {}, true})) / every, 1, 1e-9) << nodes;
}

TEST(Surroundings, HoldEachNodeByItsShareOfTheSurface) {
    const Project solid = lump(filled);
    const std::vector<OuterNode> outer = outerNodes(*solid.network);
    double sizes = 0;
    for (const OuterNode& node : outer)
        sizes += node.size;
    EXPECT_NEAR(sizes / static_cast<double>(outer.size()), 1, 1e-12);
    const auto tethers = tethersOf({2, 3, 5}, outer);
    ASSERT_EQ(tethers.size(), (outer.size() + 1) / 2);
    EXPECT_EQ(tethers[1].node, outer[2].node);
    EXPECT_EQ(tethers[1].springConstant, 3 * outer[2].size);
    EXPECT_EQ(tethers[1].viscosity, 5 * outer[2].size);
}

} // namespace
} // namespace esm

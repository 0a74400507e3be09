#include "core/solid/rigid_core.h"

#include "tests/support/lattice_block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace esm {
namespace {

using Eigen::Vector3d;

std::vector<char> coresOf(const test::LatticeBlock& block) {
    std::vector<std::uint32_t> body(block.nodes.size());
    std::iota(body.begin(), body.end(), 0U);
    return rigidCores(block.nodes, block.springs, {body});
}

TEST(RigidCore, TakesInAWholeLatticeWithSecondNeighbours) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::BodyCentred}) {
        const test::LatticeBlock block = test::latticeBlock(kind, 5, true);
        const std::vector<char> isRigid = coresOf(block);
        EXPECT_EQ(std::count(isRigid.begin(), isRigid.end(), 1), std::ssize(block.nodes)) << wordOf(kind);
    }
}

TEST(RigidCore, IsNoneOfWhatHasNoTriangle) {
    for (const LatticeKind kind : {LatticeKind::Cubic, LatticeKind::Diamond}) {
        const std::vector<char> isRigid = coresOf(test::latticeBlock(kind, 4, false));
        EXPECT_EQ(std::count(isRigid.begin(), isRigid.end(), 1), 0) << wordOf(kind);
    }
}

// Between the tetrahedra of a regular diamond lattice lie octahedra, of which no node has three springs to a
// triangle of the others.
TEST(RigidCore, StopsWhereNothingRigidCanBeShownNodeByNode) {
    const test::LatticeBlock block = test::latticeBlock(LatticeKind::Diamond, 5, true);
    const std::vector<char> isRigid = coresOf(block);
    EXPECT_LT(std::count(isRigid.begin(), isRigid.end(), 1), std::ssize(block.nodes) / 2);
    EXPECT_EQ(rigidityOf(block.nodes, block.springs).floppyModes, 0U);
}

// What hangs on two springs, or on many in one plane, may move.
TEST(RigidCore, LeavesOutWhatIsHeldLoosely) {
    test::LatticeBlock block = test::latticeBlock(LatticeKind::Cubic, 3, true);
    const auto count = static_cast<std::uint32_t>(block.nodes.size());
    block.nodes.emplace_back(-1, 0.3, 0.4);
    block.springs.insert(block.springs.end(), {{0, count, 1}, {1, count, 1}});
    block.nodes.emplace_back(0.5, 0.5, 0);
    for (std::uint32_t node = 0; node < count; ++node)
        if (std::abs(block.nodes[node].z()) < 1e-9) block.springs.push_back({node, count + 1, 1});
    const std::vector<char> isRigid = coresOf(block);
    EXPECT_EQ(std::count(isRigid.begin(), isRigid.end(), 1), std::ptrdiff_t{count});
    EXPECT_FALSE(isRigid[count] || isRigid[count + 1]);
    EXPECT_EQ(rigidityOf(block.nodes, block.springs).floppyModes, 2U);
}

// Two cubes that share no node and hang together by one spring: the larger one is the core.
TEST(RigidCore, IsTheLargestOfABody) {
    test::LatticeBlock block = test::latticeBlock(LatticeKind::Cubic, 2, true);
    const auto small = static_cast<std::uint32_t>(block.nodes.size());
    const test::LatticeBlock large = test::latticeBlock(LatticeKind::Cubic, 3, true);
    for (const Vector3d& node : large.nodes)
        block.nodes.emplace_back(node + Vector3d(9, 2, 1));
    for (const LatticeSpring& spring : large.springs)
        block.springs.push_back({spring.first + small, spring.second + small, spring.constant});
    block.springs.push_back({0, small, 1});
    const std::vector<char> isRigid = coresOf(block);
    EXPECT_TRUE(std::all_of(isRigid.begin() + small, isRigid.end(), [](char is) { return is == 1; }));
    EXPECT_EQ(std::count(isRigid.begin(), isRigid.end(), 1), std::ssize(large.nodes));
}

} // namespace
} // namespace esm

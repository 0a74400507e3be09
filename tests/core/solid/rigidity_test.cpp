#include "core/solid/rigidity.h"

#include "tests/support/lattice_block.h"
#include "tests/support/steady_progress.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace esm {
namespace {

using Eigen::Vector3d;

/// How many eigenvalues of the springs' matrix are zero, all of them computed.
std::size_t zeroModes(const test::LatticeBlock& block) {
    const auto size = static_cast<Eigen::Index>(3 * block.nodes.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
    for (const LatticeSpring& spring : block.springs) {
        const Vector3d along = (block.nodes[spring.second] - block.nodes[spring.first]).normalized();
        Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
        row.segment<3>(3 * Eigen::Index{spring.second}) = along;
        row.segment<3>(3 * Eigen::Index{spring.first}) = -along;
        stiffness.selfadjointView<Eigen::Lower>().rankUpdate(row, spring.constant);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, Eigen::EigenvaluesOnly);
    return static_cast<std::size_t>((solver.eigenvalues().array() < 1e-9).count());
}

struct CountedLattice {
    LatticeKind kind;
    double width; ///< in spacings
    std::size_t nodes, zeroModes;
};

// Zero modes of lattices with nearest neighbours alone, moving and turning the whole among them.
const std::vector<CountedLattice> countedLattices{
    {LatticeKind::Cubic, 4, 125, 75},
    {LatticeKind::BodyCentred, 8 / std::sqrt(3.0), 189, 90},
    {LatticeKind::Diamond, 12 / std::sqrt(3.0) - 0.1, 216, 315}};

TEST(Rigidity, CountsTheFloppyModesOfNearestNeighbours) {
    for (const CountedLattice& lattice : countedLattices) {
        const test::LatticeBlock block = test::latticeBlock(lattice.kind, lattice.width, false);
        ASSERT_EQ(block.nodes.size(), lattice.nodes);
        EXPECT_EQ(zeroModes(block), lattice.zeroModes);
        const Rigidity rigidity = rigidityOf(block.nodes, block.springs);
        EXPECT_EQ(rigidity.bodies, 1U);
        EXPECT_EQ(rigidity.floppyModes, lattice.zeroModes - 6) << wordOf(lattice.kind);
    }
}

TEST(Rigidity, OfLatticesWithSecondNeighboursIsWhole) {
    for (const CountedLattice& lattice : countedLattices) {
        const test::LatticeBlock block = test::latticeBlock(lattice.kind, lattice.width, true);
        EXPECT_EQ(zeroModes(block), 6U);
        EXPECT_EQ(rigidityOf(block.nodes, block.springs).floppyModes, 0U) << wordOf(lattice.kind);
    }
}

TEST(Rigidity, HoldsEachBodyByItself) {
    const test::LatticeBlock one = test::latticeBlock(LatticeKind::Cubic, 2, true);
    test::LatticeBlock both = one;
    for (const Vector3d& node : one.nodes)
        both.nodes.emplace_back(node + Vector3d(7, 3, -2));
    const auto count = static_cast<std::uint32_t>(one.nodes.size());
    for (const LatticeSpring& spring : one.springs)
        both.springs.push_back({spring.first + count, spring.second + count, spring.constant});
    EXPECT_EQ(rigidityOf(both.nodes, both.springs).bodies, 2U);
    EXPECT_EQ(rigidityOf(both.nodes, both.springs).floppyModes, 0U);
    // A single spring hinges one on the other: three turns of the second, and two of the spring's far end.
    both.springs.push_back({0, count, 1});
    EXPECT_EQ(rigidityOf(both.nodes, both.springs).bodies, 1U);
    EXPECT_EQ(rigidityOf(both.nodes, both.springs).floppyModes, 5U);
    // A node alone and two at one spring are rigid bodies as well.
    EXPECT_EQ(rigidityOf({{0, 0, 0}, {1, 2, 3}, {4, 2, 1}}, {{0, 2, 1}}).floppyModes, 0U);
    EXPECT_EQ(rigidityOf({{0, 0, 0}, {1, 2, 3}, {4, 2, 1}}, {{0, 2, 1}}).bodies, 2U);
    EXPECT_EQ(rigidityOf({}, {}).bodies, 0U);
}

TEST(Rigidity, FindsTheTurnOfAHinge) {
    // Two tetrahedra at one edge, each rigid, turn about it.
    const std::vector<Vector3d> nodes{{0, 0, 0},     {1, 0, 0},  {0, 1, 0},
                                      {0.3, 0.4, 1}, {0, -1, 0}, {0.4, -0.3, -1}};
    std::vector<LatticeSpring> springs;
    for (const std::array<std::uint32_t, 4>& four :
         {std::array<std::uint32_t, 4>{0, 1, 2, 3}, std::array<std::uint32_t, 4>{0, 1, 4, 5}})
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                springs.push_back({four[i], four[j], 1});
    EXPECT_EQ(rigidityOf(nodes, springs).floppyModes, 1U);
}

TEST(Rigidity, DoesNotDependOnWhereAndHowLargeTheLatticeIs) {
    test::LatticeBlock block = test::latticeBlock(LatticeKind::Diamond, 5, false);
    const std::size_t floppy = rigidityOf(block.nodes, block.springs).floppyModes;
    for (Vector3d& node : block.nodes)
        node = 1e-3 * node + Vector3d(100, -50, 20);
    for (LatticeSpring& spring : block.springs)
        spring.constant *= 1e-6;
    EXPECT_EQ(rigidityOf(block.nodes, block.springs).floppyModes, floppy);
}

TEST(Rigidity, TellsItsProgress) {
    const test::LatticeBlock block = test::latticeBlock(LatticeKind::Cubic, 3, true);
    test::expectGoodProgress(
        [&](const Progress& progress) { rigidityOf(block.nodes, block.springs, progress); });
}

} // namespace
} // namespace esm

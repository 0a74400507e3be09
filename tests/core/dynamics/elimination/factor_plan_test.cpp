#include "core/dynamics/elimination/factor_plan.h"

#include "core/dynamics/step_matrix.h"
#include "tests/support/lattice_block.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

FactorPlan planOf(const SpringSystem& system) {
    const std::vector<char> given(system.mass.size(), 0);
    return planFactor(laplacianMatrix(system, {1, 0.01, 0}, given), system.network->restPositions);
}

/// A line of springs that is wound up tightly.
SpringSystem spiral(int nodes) {
    SpringNetwork network;
    for (int i = 0; i < nodes; ++i) {
        network.restPositions.emplace_back(0.1 * std::cos(0.05 * i), 0.1 * std::sin(0.05 * i), 1e-6 * i);
        if (i > 0) tissue::addSpring(network, static_cast<std::size_t>(i) - 1, static_cast<std::size_t>(i));
    }
    return makeSpringSystem(tissue::model(std::move(network), {}));
}

} // namespace

// Entries of panels, whose triangles and joined columns hold zeros too.
TEST(FactorPlan, KeepsFewNumbersOfLinesNetsAndLattices) {
    const SpringSystem net = makeSpringSystem(tissue::fromMesh(tissue::sphereMesh(5, 0.1), {}));
    EXPECT_LT(planOf(net).valueCount, 62 * net.mass.size());
    EXPECT_LT(planOf(spiral(5000)).valueCount, std::size_t{60 * 5000});
    const test::LatticeBlock block = test::latticeBlock(LatticeKind::BodyCentred, 13, true);
    SpringNetwork network;
    network.restPositions = block.nodes;
    for (const LatticeSpring& spring : block.springs)
        tissue::addSpring(network, spring.first, spring.second);
    const SpringSystem lattice = makeSpringSystem(tissue::model(std::move(network), {}));
    const auto nodes = static_cast<double>(lattice.mass.size());
    EXPECT_LT(static_cast<double>(planOf(lattice).valueCount), 14 * std::pow(nodes, 4.0 / 3));
}

TEST(FactorPlan, HasBlocksThatFollowEachOtherAndChangeLaterOnes) {
    const SpringSystem net = makeSpringSystem(tissue::fromMesh(tissue::sphereMesh(3, 0.1), {}));
    const FactorPlan plan = planOf(net);
    int next = 0;
    std::size_t values = 0;
    for (std::size_t number = 0; number < plan.blocks.size(); ++number) {
        const FactorBlock& block = plan.blocks[number];
        EXPECT_EQ(block.begin, std::exchange(next, block.end));
        EXPECT_EQ(block.values, values);
        const auto below = plan.below(block);
        EXPECT_TRUE(std::is_sorted(below.begin(), below.end()));
        EXPECT_TRUE(below.empty() || below.front() >= block.end);
        for (const int child : plan.links[number].children) {
            const auto changed = plan.below(plan.blocks[static_cast<std::size_t>(child)]);
            const std::vector<int>& places = plan.links[static_cast<std::size_t>(child)].placesInParent;
            ASSERT_EQ(places.size(), changed.size());
            for (std::size_t i = 0; i < changed.size(); ++i) {
                const auto place = static_cast<std::size_t>(places[i]);
                const int row = place < block.width() ? block.begin + static_cast<int>(place)
                                                      : below[place - block.width()];
                EXPECT_EQ(row, changed[i]);
            }
        }
        values += block.width() * block.height();
    }
    EXPECT_EQ(next, std::ssize(net.mass));
    EXPECT_EQ(plan.valueCount, values);
}

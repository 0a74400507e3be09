#include "core/dynamics/kernel/node_order.h"
#include "tests/core/dynamics/kernel/networks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace esm;

namespace {

using Order = std::vector<std::uint32_t>;

std::vector<std::uint32_t> placesIn(const Order& order) {
    std::vector<std::uint32_t> places(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        places[order[i]] = static_cast<std::uint32_t>(i);
    return places;
}

std::size_t bandwidth(const SpringSystem& system, const Order& order) {
    const auto places = placesIn(order);
    std::size_t widest = 0;
    for (const auto& spring : system.springs) {
        const auto [low, high] = std::minmax(places[spring.first], places[spring.second]);
        widest = std::max<std::size_t>(widest, high - low);
    }
    return widest;
}

void expectPermutation(Order order, std::size_t nodes) {
    std::sort(order.begin(), order.end());
    Order all(nodes);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(order, all);
}

} // namespace

TEST(NodeOrder, OfAChainFollowsTheChain) {
    SpringSystem chain = network::withNodes(100);
    for (std::uint32_t i = 0; i + 1 < 100; ++i)
        network::join(chain, i, i + 1);
    const SpringSystem mixed = network::renumbered(chain, network::randomOrder(100, 3));
    const Order order = reverseCuthillMcKee(mixed);
    expectPermutation(order, 100);
    EXPECT_EQ(bandwidth(mixed, order), 1U);
}

TEST(NodeOrder, OfASurfaceKeepsNeighboursNear) {
    const SpringSystem grid =
        makeSpringSystem(tissue::fromMesh(tissue::gridMesh(40, 0.1), tissue::Parameters{}));
    const SpringSystem mixed = network::renumbered(grid, network::randomOrder(1600, 5));
    const Order order = reverseCuthillMcKee(mixed);
    expectPermutation(order, 1600);
    EXPECT_LE(bandwidth(mixed, order), 2 * 40U);
}

TEST(NodeOrder, KeepsComponentsAndLoneNodesApart) {
    SpringSystem system = network::withNodes(9);
    network::join(system, 7, 1);
    network::join(system, 3, 5);
    network::join(system, 5, 8);
    const Order order = reverseCuthillMcKee(system);
    expectPermutation(order, 9);
    EXPECT_EQ(bandwidth(system, order), 1U);
}

TEST(NodeOrder, TakesNodesThatAreJoinedTwiceOrToMany) {
    SpringSystem system = network::withNodes(50);
    for (std::uint32_t i = 1; i < 50; ++i)
        network::join(system, 0, i);
    network::join(system, 0, 1);
    network::join(system, 1, 0);
    expectPermutation(reverseCuthillMcKee(system), 50);
}

TEST(NodeOrder, OfNothingIsNothing) {
    EXPECT_TRUE(reverseCuthillMcKee(network::withNodes(0)).empty());
    expectPermutation(reverseCuthillMcKee(network::withNodes(3)), 3);
}

TEST(NodeOrder, DependsOnNothingButTheNetwork) {
    const SpringSystem system = network::random(network::Contents{}, 11);
    EXPECT_EQ(reverseCuthillMcKee(system), reverseCuthillMcKee(system));
}

#include "core/support/id.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

struct Leaf : Identified<Leaf> {
    int size = 0;

    bool operator==(const Leaf&) const = default;
};

std::vector<Leaf> threeLeaves() {
    std::vector<Leaf> leaves(3);
    numberByPlace(leaves);
    for (Leaf& leaf : leaves)
        leaf.size = static_cast<int>(10 * leaf.id.number);
    return leaves;
}

TEST(Id, StaysWithThePartThatMoves) {
    std::vector<Leaf> leaves = threeLeaves();
    const Id<Leaf> first = leaves[0].id;
    std::swap(leaves[0], leaves[2]);
    EXPECT_EQ(placeOf(leaves, first), 2U);
    EXPECT_EQ(partOf(leaves, first).size, 10);
    EXPECT_EQ(findPart(leaves, first), &leaves[2]);
}

TEST(Id, IsNoPartOfWhatIsCompared) {
    Leaf leaf = threeLeaves()[0], other = leaf;
    other.id = {9};
    EXPECT_EQ(leaf, other);
    other.size = 11;
    EXPECT_NE(leaf, other);
}

TEST(Id, OfWhatIsNotThereFindsNothing) {
    const std::vector<Leaf> leaves = threeLeaves();
    EXPECT_EQ(placeOf(leaves, {7}), std::nullopt);
    EXPECT_EQ(findPart(leaves, {7}), nullptr);
    EXPECT_ANY_THROW(partOf(leaves, {7}));
}

TEST(Id, NextIsAboveTheHighest) {
    std::vector<Leaf> leaves = threeLeaves();
    leaves.erase(leaves.begin() + 1);
    EXPECT_EQ(nextId(leaves), Id<Leaf>{4});
    EXPECT_EQ(nextId(std::vector<Leaf>{}), Id<Leaf>{1});
}

} // namespace

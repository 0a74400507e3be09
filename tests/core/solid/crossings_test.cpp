#include "core/solid/crossings.h"

#include "tests/support/crossed_ball.h"
#include "tests/support/solid_surfaces.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

std::vector<Crossing> crossings(const TriangleMesh& mesh, double spacing) {
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    return crossingsOf(bodies, std::vector<double>(bodies.size(), spacing));
}

TEST(Crossings, AreNoneWhereBodiesLieWithinEachOther) {
    TriangleMesh mesh = test::shell(1, 0.6);
    test::append(mesh, test::turned(test::ball(0.25, {0.1, 0, 0})));
    test::append(mesh, test::ball(0.5, {3, 0, 0}));
    EXPECT_TRUE(crossings(mesh, 0.1).empty());
}

TEST(Crossings, AreAsWideAsWhatLiesOnTheWrongSide) {
    const std::vector<Crossing> found = crossings(test::crossedBall(), 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GT(found[0].pairs, 2U);
    EXPECT_TRUE(found[0].isNarrow());
    EXPECT_GT(found[0].width, 0.01);
    EXPECT_LT(found[0].width, 0.06);
    EXPECT_NEAR(found[0].place.norm(), 1.05, 0.05);
    EXPECT_FALSE(crossings(test::crossedBall(), 0.02)[0].isNarrow());
}

TEST(Crossings, OfBallsAreAsWideAsTheBallsHaveInCommon) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0});
    test::append(mesh, test::ball(1, {1.6, 0.05, 0.02}));
    const std::vector<Crossing> found = crossings(mesh, 0.2);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].isNarrow());
    EXPECT_NEAR(found[0].width, 1.2, 0.1); // of the circle along which they meet
}

// A small ball that is stuck in a large one: the circle where they meet is as narrow as both at a slant.
TEST(Crossings, ReachToAllThatLiesBeyondThem) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0});
    test::append(mesh, test::ball(0.2, {0.83, 0.01, 0.02}));
    const std::vector<Crossing> found = crossings(mesh, 2);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].width, 0.37, 0.04);
    // Half of it lies within both: the ball's far side counts.
    EXPECT_LT(found[0].place.norm(), 0.93);
}

TEST(Crossings, KnowTheFinestLatticeThatTheyTouch) {
    TriangleMesh mesh = test::ball(1, {0, 0, 0});
    test::append(mesh, test::ball(0.2, {1, 0.01, 0.02}));
    const std::vector<ClosedBody> bodies = closedBodiesOf(mesh);
    ASSERT_EQ(bodies.size(), 2U);
    const std::vector<Crossing> found = crossingsOf(bodies, {0.5, 0.1});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].spacing, 0.1);
    EXPECT_FALSE(found[0].isNarrow());
}

} // namespace
} // namespace esm

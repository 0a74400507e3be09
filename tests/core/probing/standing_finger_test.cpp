#include "core/probing/standing_finger.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// Pressed 4 mm deep within 0.05 s, where 0.3 N remain in the end.
const TimeCurve fading{
    {{0, 0, 0}, {0.025, 0.002, 2}, {0.05, 0.004, 3}, {0.1, 0.004, 0.4}, {0.2, 0.004, 0.5}, {0.4, 0.004, 0.3}},
    {0.004, 0.3},
    0.15};

TEST(StandingFinger, LeavesOutWhatDampersBearWhileItMoves) {
    const StandingFinger standing = standingFinger(fading);
    ASSERT_EQ(standing.points.size(), 3U);
    EXPECT_EQ(standing.points.front().time, 0.1);
    EXPECT_EQ(standing.largest.time, 0.2);
    EXPECT_EQ(standing.largest.force, 0.5);
}

TEST(StandingFinger, CountsTheTimeConstantFromTheLargestForce) {
    EXPECT_DOUBLE_EQ(*fallenAt(fading), 0.35);
    TimeCurve never = fading;
    never.timeConstant.reset();
    EXPECT_FALSE(fallenAt(never));
}

TEST(StandingFinger, KnowsWhereTheForceHardlyFalls) {
    EXPECT_FALSE(hasNextToNoWay(fading));
    TimeCurve stays = fading;
    stays.end.force = 0.499;
    EXPECT_TRUE(hasNextToNoWay(stays));
}

} // namespace
} // namespace esm

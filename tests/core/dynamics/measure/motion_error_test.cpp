#include "core/dynamics/measure/motion_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace esm {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

TEST(MotionError, IsRelativeToTheMotionItself) {
    MotionError error;
    EXPECT_TRUE(std::isinf(error.relative()));
    error.add({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}});
    EXPECT_TRUE(std::isinf(error.relative()));
    error.add({{0, 0, 3}, {1, 0, 1}}, {{0, 0, 0}, {1, 4, 1}}, {{0, 0, 0}, {1, 0, 1}});
    EXPECT_DOUBLE_EQ(error.relative(), 5.0 / 4);
}

TEST(RelativeError, TakesTheTimesThatBothHave) {
    const Trajectory reference{{0, {{0, 0, 0}}}, {1, {{2, 0, 0}}}, {2, {{0, 2, 0}}}};
    EXPECT_DOUBLE_EQ(relativeError({{0, {{0, 0, 0}}}, {1, {{3, 0, 0}}}, {5, {{9, 9, 9}}}}, reference), 0.5);
    EXPECT_EQ(relativeError({{0, {{0, 0, 0}}}, {7, {{3, 0, 0}}}}, reference), none);
}

TEST(ComparedFrames, AreFewHoweverManyThereAre) {
    ComparedFrames coarse(10, 1e-3), finer(10, 1e-3);
    for (int step = 0; step <= 5000; ++step)
        coarse.add(2e-3 * step, {{2e-3 * step, 0, 0}});
    for (int step = 0; step <= 10000; ++step)
        finer.add(1e-3 * step, {{1e-3 * step, 0, 0}});
    EXPECT_LE(finer.frames().size(), 100U);
    EXPECT_GT(finer.frames().size(), 50U);
    EXPECT_GT(finer.frames().rbegin()->first, 9800);
    std::size_t shared = 0;
    for (const auto& [number, positions] : finer.frames()) {
        EXPECT_NEAR(positions.front().x(), 1e-3 * static_cast<double>(number), 1e-9);
        shared += coarse.frames().count(number);
    }
    EXPECT_GE(shared, 40U);
}

TEST(ComparedFrames, AreThoseOfWholeIntervals) {
    ComparedFrames compared(0.3, 0.1), brief(0.1, 1), dense(1, 1e-300);
    for (int step = 0; step <= 10; ++step)
        compared.add(0.03 * step, {{0, 0, 0}});
    EXPECT_EQ(compared.frames().size(), 2U);
    EXPECT_EQ(compared.frames().count(3), 1U);
    brief.add(0, {{0, 0, 0}});
    brief.add(0.1, {{0, 0, 0}});
    EXPECT_EQ(brief.frames().count(1), 1U);
    for (const double time : {0.0, 0.1, 0.2, 1.0})
        dense.add(time, {{0, 0, 0}});
    EXPECT_EQ(dense.frames().size(), 4U);
}

TEST(RemainingError, FollowsHowMuchHalvingGains) {
    EXPECT_DOUBLE_EQ(remainingError({0.1}, 2), 0.9);                // it may gain little
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.2}, 2), 0.1);           // first order
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4}, 2), 0.1);           // second, but that may be luck
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4, 1.6}, 2), 0.1 / 3);  // second
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4, 0.8}, 2), 0.1);      // by fits and starts
    EXPECT_DOUBLE_EQ(remainingError({0.1, 10, 40}, 2), 2.5 / 3);    // luck
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4, 16}, 2), 1. / 3);    // luck not long ago
    EXPECT_DOUBLE_EQ(remainingError({0.1, 1.6, 25.6}, 4), 0.1 / 3); // fourth, of which no more is believed
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.1}, 2), 0.9);           // none at all
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.01, 1}, 2), 0.9);
    EXPECT_EQ(remainingError({0, 0, 0}, 2), 0);
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4, 1.6}, 1), 0.4); // more than the first order can gain
    const double half = std::sqrt(0.5);
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.1 / half, 0.2}, 0.5), 0.1 * half / (1 - half));
    EXPECT_DOUBLE_EQ(remainingError({0.1, 0.4, 0.4}, 0.5), 0.1 * 4 * half * 0.9 / (1 - 0.9)); // chance
}

TEST(HalvingChanges, ExtrapolateWhatGains) {
    HalvingChanges changes;
    for (const double change : {0.04, 0.02, 0.01})
        changes.add(change, 2);
    EXPECT_FALSE(changes.standsStill());
    EXPECT_DOUBLE_EQ(changes.remaining(), 0.01);
}

TEST(HalvingChanges, StandStillWhereThreeGainNothing) {
    HalvingChanges changes;
    for (const double change : {0.04, 0.002, 0.0028, 0.003})
        changes.add(change, 2);
    EXPECT_FALSE(changes.standsStill());
    EXPECT_FALSE(changes.gained());
    changes.add(0.0028, 2);
    EXPECT_TRUE(changes.standsStill());
    EXPECT_DOUBLE_EQ(changes.remaining(), 0.003);
    for (const double change : {0.001, 0.0003})
        changes.add(change, 2);
    EXPECT_FALSE(changes.standsStill());
    EXPECT_LT(changes.remaining(), 0.001);
}

TEST(HalvingChanges, DoNotStandStillBeforeStepsFollowTheMotion) {
    HalvingChanges changes;
    for (int halving = 0; halving < 5; ++halving)
        changes.add(0.5, 2);
    EXPECT_FALSE(changes.standsStill());
    EXPECT_DOUBLE_EQ(changes.remaining(), 4.5);
    for (int halving = 0; halving < 3; ++halving)
        changes.add(0.5, 2);
    EXPECT_TRUE(changes.standsStill()) << "no motion is worth more of them";
    EXPECT_DOUBLE_EQ(changes.remaining(), 4.5);
}

TEST(HalvingChanges, OfFloatStandStillAtOnce) {
    HalvingChanges changes({1, 1});
    for (const double change : {0.04, 0.02})
        changes.add(change, 2);
    EXPECT_FALSE(changes.standsStill());
    changes.add(0.019, 2);
    EXPECT_TRUE(changes.standsStill());
    EXPECT_DOUBLE_EQ(changes.remaining(), 0.019 * 9) << "more than a part of what rounding spoils";
}

} // namespace
} // namespace esm

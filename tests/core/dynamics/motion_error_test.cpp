#include "core/dynamics/motion_error.h"

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

TEST(RemainingError, FollowsHowMuchHalvingGains) {
    EXPECT_DOUBLE_EQ(remainingError(0.1, none), 0.1);
    EXPECT_DOUBLE_EQ(remainingError(0.1, 0.2), 0.1);     // first order
    EXPECT_DOUBLE_EQ(remainingError(0.1, 0.4), 0.1 / 3); // second
    EXPECT_DOUBLE_EQ(remainingError(0.1, 0.1), 0.1);     // none that could be relied on
    EXPECT_EQ(remainingError(0, 0), 0);
}

} // namespace
} // namespace esm

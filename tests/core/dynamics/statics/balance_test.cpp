#include "core/dynamics/statics/balance.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// Halves what is left over, down to a floor that rounding would set.
struct Descent {
    double left, floor;

    bool find(double tolerance) {
        return findRest(
            tolerance, [&] { return left; },
            [&] {
                if (left <= floor) return false;
                left /= 2;
                return true;
            });
    }
};

TEST(Balance, IsFoundWhereLittleEnoughIsLeft) {
    Descent descent{1, 0};
    EXPECT_TRUE(descent.find(balanced));
    EXPECT_LE(descent.left, balanced);
}

TEST(Balance, IsNearlyEnoughWhereRoundingEndsTheWay) {
    EXPECT_TRUE((Descent{1, 0.9 * nearlyBalanced}).find(balanced));
    EXPECT_FALSE((Descent{1, 2 * nearlyBalanced}).find(balanced));
}

TEST(Balance, IsNotSoughtForEver) {
    int steps = 0;
    EXPECT_FALSE(findRest(
        balanced, [] { return 1.0; }, [&] { return ++steps > 0; }));
    EXPECT_EQ(steps, 1000);
}

} // namespace
} // namespace esm

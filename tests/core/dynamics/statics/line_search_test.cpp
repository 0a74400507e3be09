#include "core/dynamics/statics/line_search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace esm {
namespace {

TEST(LineSearch, GoesAllTheWayWhereTheSlopeIsSpentThere) {
    const auto at = [](double part) { return OnWay{part * part - 2 * part, 2 * part - 2}; };
    EXPECT_EQ(lowerPart(at(0), at), 1);
}

TEST(LineSearch, ShortensAWayThatGoesFarTooFar) {
    const auto at = [](double part) { return OnWay{1e6 * part * part - part, 2e6 * part - 1}; };
    const double part = lowerPart(at(0), at).value();
    EXPECT_LT(std::abs(at(part).slope), 0.5);
}

// As a sheet that meets the finger: what lies behind the place where the slope jumps up has to be reached.
TEST(LineSearch, FindsTheBottomBehindAJumpOfTheCurvature) {
    for (const double met : {0.7, 0.01, 1e-6}) {
        const auto at = [&](double part) {
            const double inside = std::max(0.0, part - met);
            return OnWay{0.5e5 * inside * inside - part, 1e5 * inside - 1};
        };
        const double part = lowerPart(at(0), at).value();
        EXPECT_GT(part, met) << met;
        EXPECT_LT(std::abs(at(part).slope), 0.5) << met;
    }
}

TEST(LineSearch, TrustsTheSlopeWhereValuesAreRounded) {
    const auto at = [](double part) { return OnWay{1.0, 1e-12 * (part - 0.25)}; };
    const double part = lowerPart(at(0), at).value();
    EXPECT_NEAR(part, 0.25, 0.13);
}

TEST(LineSearch, FindsNothingOnAWayThatGoesUp) {
    const auto at = [](double part) { return OnWay{1 + part, 1}; };
    EXPECT_FALSE(lowerPart({1, -1}, at));
}

} // namespace
} // namespace esm

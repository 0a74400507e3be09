#include "core/texture/atlas/charts/chart_border.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

/// A block of 10 by 10 that a slit cuts from above down to 1, with ends as wide as told.
PlanePoints slit(double below, double above) {
    return {{-5, 0},        {5, 0},          {5, 10},          {above / 2, 10},
            {below / 2, 1}, {-below / 2, 1}, {-above / 2, 10}, {-5, 10}};
}

TEST(ChartBorder, OfAConvexChartIsClearHoweverWideTheGap) {
    const PlanePoints square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_TRUE(keepsClear(square, 0));
    EXPECT_TRUE(keepsClear(square, 100));
    EXPECT_TRUE(keepsClear({{0, 0}, {1, 0}, {0, 1}}, 100));
}

TEST(ChartBorder, MustNotCrossOrTouchItself) {
    EXPECT_FALSE(keepsClear({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 0));
    EXPECT_FALSE(keepsClear({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, 0))
        << "it comes down to its lower side";
    EXPECT_FALSE(keepsClear({{0, 0}, {4, 0}, {2, 0}, {2, 3}}, 0)) << "it goes back on itself";
}

TEST(ChartBorder, KeepsTheGapAcrossASlit) {
    EXPECT_TRUE(keepsClear(slit(0.1, 0.1), 0.09));
    EXPECT_FALSE(keepsClear(slit(0.1, 0.1), 0.11));
}

TEST(ChartBorder, MayBeNearWhereItTurnsACorner) {
    EXPECT_TRUE(keepsClear(slit(0.1, 8), 4)) << "the surface is as near there";
    for (const double clearance : {1.5, 4.0})
        EXPECT_FALSE(keepsClear(slit(0.1, 2), clearance)) << "far around the corner for so narrow a slit";
}

TEST(ChartBorder, MayBeNearAcrossTheChartItself) {
    const PlanePoints strip{{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}};
    EXPECT_TRUE(keepsClear(strip, 1));
}

} // namespace
} // namespace esm

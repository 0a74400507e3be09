#include "core/texture/atlas/row_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace esm;

namespace {

/// Tallest first, as the layout asks for.
std::vector<PatchShape> someShapes() {
    std::vector<PatchShape> shapes;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const double base = 1 + 0.5 * std::sin(7.0 * i);
        shapes.push_back({base, base * (0.5 + 0.4 * std::cos(3.0 * i)), base * 0.01 * (60 - i), i, 0});
    }
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const PatchShape& a, const PatchShape& b) { return a.height > b.height; });
    shapes.push_back({0, 0, 0, 60, 0});
    return shapes;
}

} // namespace

TEST(RowLayout, KeepsEveryShapeOnItsPage) {
    const std::vector<PatchShape> shapes = someShapes();
    constexpr double scale = 20, size = 64, gap = 2;
    const PatchLayout layout = layoutRows(shapes, scale, {size, gap});
    ASSERT_EQ(layout.corners.size(), shapes.size());
    EXPECT_GT(layout.pages, 1);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const PatchCorners& corners = layout.corners[i];
        EXPECT_LT(layout.page[i], layout.pages);
        EXPECT_NEAR((corners[1] - corners[0]).norm(), scale * shapes[i].base, 1e-9);
        for (const Eigen::Vector2d& corner : corners)
            for (const double place : corner)
                EXPECT_TRUE(place >= gap / 2 - 1e-9 && place <= size - gap / 2 + 1e-9) << corner.transpose();
    }
}

TEST(RowLayout, RefusesAShapeLargerThanAPage) {
    EXPECT_EQ(layoutRows({{1, 0.5, 0.5, 0, 0}}, 126.01, {128, 2}).pages, 0);
    EXPECT_EQ(layoutRows({{1, 0.5, 0.5, 0, 0}}, 125.99, {128, 2}).pages, 1);
    EXPECT_EQ(layoutRows({{0.5, 0.2, 1, 0, 0}}, 126.01, {128, 2}).pages, 0);
}

TEST(ClearingShift, LeavesExactlyTheGap) {
    const PatchCorners placed{Eigen::Vector2d(0, 10), {10, 10}, {5, 0}};
    const PatchCorners turned{Eigen::Vector2d(10, 0), {0, 0}, {5, 10}};
    const double shift = clearingShift(placed, turned, 2);
    EXPECT_NEAR(shift, 5 + 2 * std::hypot(1, 0.5), 1e-9); // the slanted sides run side by side
    const PatchCorners above{Eigen::Vector2d(0, -10), {10, -10}, {5, -20}};
    EXPECT_EQ(clearingShift(placed, above, 2), -std::numeric_limits<double>::infinity());
}

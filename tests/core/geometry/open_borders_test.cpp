#include "core/geometry/open_borders.h"

#include "tests/support/cut_ball.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

TEST(OpenBorders, KnowHowLongAndHowWideASlitIs) {
    const TriangleMesh mesh = test::cutBall().mesh;
    const std::vector<OpenBorder> borders = openBordersOf(mesh);
    ASSERT_EQ(borders.size(), 1U);
    EXPECT_EQ(borders[0].loop.size(), 162U);
    EXPECT_NEAR(borders[0].length, 162 * 2 * M_PI * 0.06 / 120, 2e-3);
    EXPECT_NEAR(borders[0].gap, 6e-4, 1e-5);
}

TEST(OpenBorders, NameTheOneWithTheMostEdgesFirst) {
    TriangleMesh sheet = flatSquare(0.1, 20);
    sheet.triangles.erase(sheet.triangles.begin() + 410, sheet.triangles.begin() + 412); // one cell
    const std::vector<OpenBorder> borders = openBordersOf(sheet);
    ASSERT_EQ(borders.size(), 2U);
    EXPECT_EQ(borders[0].loop.size(), 80U);
    EXPECT_NEAR(borders[0].length, 0.4, 1e-9);
    EXPECT_EQ(borders[1].loop.size(), 4U);
    EXPECT_NEAR(borders[1].length, 0.02, 1e-9);
}

TEST(OpenBorders, AreNoneOfAClosedSurface) {
    EXPECT_TRUE(openBordersOf(test::ball()).empty());
}

TEST(OpenBorders, TakeEachOfTwoFansInOneVertexForItself) {
    // Two squares that touch in a corner.
    const TriangleMesh touching{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}},
                                {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}}};
    const std::vector<OpenBorder> borders = openBordersOf(touching);
    ASSERT_EQ(borders.size(), 2U);
    for (const OpenBorder& border : borders)
        EXPECT_EQ(border.loop.size(), 4U);
}

/// Three sheets that meet in an edge have borders that go from sheet to sheet at its ends: no loops.
TEST(OpenBorders, LeaveOutWhatEndsWhereSheetsBranch) {
    const std::vector<Triangle> book{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    const Borders borders = bordersOf(book);
    EXPECT_TRUE(borders.loops.empty());
    EXPECT_EQ(borders.looseEdges, 6U);
}

} // namespace
} // namespace esm

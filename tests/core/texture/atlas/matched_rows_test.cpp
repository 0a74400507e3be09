#include "core/texture/atlas/matched_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>

using namespace esm;

namespace {

/// Tallest first, some of them alike.
std::vector<PatchShape> shapesForARow(unsigned seed) {
    std::vector<PatchShape> shapes;
    for (std::uint32_t i = 0; i < 100; ++i) {
        const double phase = seed + i % 90;
        const double base = 1 + 0.3 * std::sin(7.0 * phase);
        shapes.push_back(
            {base, base * (0.5 + 0.45 * std::cos(3.0 * phase)), base * (0.6 + 0.2 * std::sin(phase)), i, 0});
    }
    std::stable_sort(shapes.begin(), shapes.end(),
                     [](const PatchShape& a, const PatchShape& b) { return a.height > b.height; });
    shapes.push_back({0, 0, 0, 100, 0});
    return shapes;
}

/// Horizontal over vertical way of the side to the left, or to the right, both to the inside.
double slant(const PatchShape& shape, const PatchStance& stance, bool ofTheRight) {
    if (!(shape.height > 0)) return 0;
    const bool ofTheFirstCorner = (stance.pointsUp == stance.isMirrored) == ofTheRight;
    return (ofTheFirstCorner ? shape.foot : shape.base - shape.foot) / shape.height;
}

/// The part of a row that a shape leaves empty, for its own size.
double emptiness(const PatchShape& shape, double rowHeight, double slantsApart) {
    return (rowHeight - shape.height) / shape.height + std::abs(slantsApart) * shape.height / shape.base;
}

/// One row that all shapes fit into, each time with the shape that leaves least of it empty.
std::vector<PatchCorners> layoutPlainly(const std::vector<PatchShape>& shapes, double scale, double gap) {
    std::list<std::size_t> waiting;
    for (std::size_t i = 1; i < shapes.size(); ++i)
        waiting.push_back(i);
    std::vector<PatchCorners> layout(shapes.size());
    PatchRow row;
    const auto place = [&](std::size_t i, const PatchStance& stance) {
        PatchCorners corners = cornersInRow(shapes[i], scale, scale * shapes[0].height, stance);
        shift(corners, row.isEmpty() ? gap / 2 : row.shiftFor(corners, gap / 2, gap), 0);
        row.add(corners);
        shift(corners, 0, gap / 2);
        layout[i] = corners;
        return slant(shapes[i], stance, true);
    };
    double slantBefore = place(0, {true, false});
    for (bool pointsUp = false; !waiting.empty(); pointsUp = !pointsUp) {
        auto best = waiting.begin();
        PatchStance stance{pointsUp, false};
        double least = std::numeric_limits<double>::infinity();
        for (auto i = waiting.begin(); i != waiting.end(); ++i)
            for (const bool isMirrored : {false, true}) {
                const double apart = slant(shapes[*i], {pointsUp, isMirrored}, false) - slantBefore;
                const double empty = emptiness(shapes[*i], shapes[0].height, apart);
                if (!(empty < least)) continue;
                least = empty;
                best = i;
                stance.isMirrored = isMirrored;
            }
        slantBefore = place(*best, stance);
        waiting.erase(best);
    }
    return layout;
}

} // namespace

TEST(MatchedRows, TakesEachTimeTheShapeThatLeavesLeastOfTheRowEmpty) {
    constexpr double scale = 20, gap = 2;
    for (const unsigned seed : {0U, 1U, 2U, 3U, 4U}) {
        const std::vector<PatchShape> shapes = shapesForARow(seed);
        const PatchLayout layout = layoutMatchedRows(shapes, scale, {1e5, gap});
        const std::vector<PatchCorners> expected = layoutPlainly(shapes, scale, gap);
        ASSERT_EQ(layout.corners.size(), expected.size());
        for (std::size_t i = 0; i < shapes.size(); ++i)
            for (std::size_t corner = 0; corner < 3; ++corner)
                EXPECT_NEAR((layout.corners[i][corner] - expected[i][corner]).norm(), 0, 1e-9)
                    << "corner " << corner << " of shape " << i << ", seed " << seed;
    }
}

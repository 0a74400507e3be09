#include "core/texture/layers/composite.h"

#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

/// Two triangles with one edge between them, on a page of one colour.
struct TwoTriangles {
    TriangleMesh mesh = flatSquare(0.1, 1);
    Atlas atlas = packAtlas(mesh, {256, 1, 8});
    std::vector<Image> pages = composite(mesh, atlas, {}, {10, 20, 30});

    /// Paints the texel in the middle between two corners of the first triangle.
    void paintBetween(std::size_t first, std::size_t second) {
        const Eigen::Vector2d middle = (atlas.corners[0][first] + atlas.corners[0][second]) / 2;
        pages[0].at(int(middle.x()), int(middle.y()))[0] = 210;
    }
    double error() const { return seamError(mesh, atlas, pages); }
};

} // namespace

TEST(SeamError, IsNoneBetweenEqualColours) {
    EXPECT_EQ(TwoTriangles().error(), 0);
}

TEST(SeamError, IsTheLargestDifferenceAcrossASharedEdge) {
    TwoTriangles model;
    model.paintBetween(0, 2);
    EXPECT_GT(model.error(), 50);
    EXPECT_LE(model.error(), 200);
}

TEST(SeamError, LeavesOutTheSurfacesBorder) {
    TwoTriangles model;
    model.paintBetween(0, 1);
    EXPECT_EQ(model.error(), 0);
}

#include "core/texture/layers/composite.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;

namespace {

TextureLayer smoothLayer() {
    return layerFromAbove(
        makePhoto(
            64, 64,
            [](int x, int y) {
                return Colour{std::uint8_t(2 * x + 40), std::uint8_t(2 * y + 60), std::uint8_t(x + y), 255};
            }),
        0.2);
}

} // namespace

TEST(CompositeOwnLayout, KeepsACheckerboardWhereItIsOnTheOrgan) {
    const TriangleMesh mesh = stretchedSheet(0.1, 7);
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2, AtlasLayout::Own});
    const std::vector<Image> pages =
        composite(mesh, atlas, {layerFromAbove(checkerboard(), 0.08)}, baseColour);
    int compared = 0;
    forEachTexelInside(mesh, atlas, pages,
                       [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                           const double column = (point.x() + 0.04) / 0.01, row = (0.04 - point.y()) / 0.01;
                           if (fromLine(column, row) < 0.06) return; // within a pixel or two of a line
                           ++compared;
                           EXPECT_EQ(colour, colourOfSquare(column, row)) << point.transpose();
                       });
    EXPECT_GT(compared, 100000);
}

TEST(CompositeOwnLayout, ShowsNoStepInsideOrAtSeams) {
    TriangleMesh mesh = stretchedSheet(0.1, 8);
    // Every other row of cells lies elsewhere in the picture, mirrored: its edges are seams.
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (Eigen::Vector2d& place : mesh.textureCoordinates[i])
            place = (i / 16) % 2 == 0 ? Eigen::Vector2d(0.45 * place.x(), place.y())
                                      : Eigen::Vector2d(1 - 0.45 * place.x(), place.y());
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2, AtlasLayout::Own});
    EXPECT_GT(seamShare(mesh, atlas), 0.1);
    EXPECT_LT(seamShare(mesh, atlas), 0.5);
    EXPECT_LE(seamError(mesh, atlas, composite(mesh, atlas, {smoothLayer()}, baseColour)), 2);
}

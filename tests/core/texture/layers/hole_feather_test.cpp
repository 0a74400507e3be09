#include "core/texture/layers/composite.h"
#include "core/texture/layers/hole_feather.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <gtest/gtest.h>

using namespace esm;
using namespace esm::test;

namespace {

constexpr Colour grey{120, 110, 100, 255}, nothing{120, 110, 100, 0};

/// A tall photo with a slanted hole, a round one, and one of a single pixel.
std::shared_ptr<const Photo> tallPhoto() {
    return makePhoto(90, 700, [](int x, int y) {
        const bool isBeyondLine = x + 0.3 * y < 60;
        const bool isInDisc = std::hypot(x - 60, y - 500) < 20;
        return isBeyondLine || isInDisc || (x == 30 && y == 650) ? nothing : grey;
    });
}

/// Pixels from a place to the middle of the nearest hole, less half a pixel, looked for one by one.
double distanceToHole(const Image& photo, int x, int y) {
    double nearest = 1e9;
    for (int row = 0; row < photo.height; ++row)
        for (int column = 0; column < photo.width; ++column)
            if (photo.at(column, row)[3] == 0) nearest = std::min(nearest, std::hypot(column - x, row - y));
    return nearest - 0.5;
}

} // namespace

TEST(HoleFeather, FadesLinearlyTowardsTheNearestHole) {
    const Image photo = tallPhoto()->image;
    constexpr double blendPixels = 32;
    const PhotoFade fade = holeFeather(photo, blendPixels);
    ASSERT_EQ(fade.spacing, 4);
    for (int y = 0; y < photo.height; y += 12)
        for (int x = 0; x < photo.width; x += 12) {
            const double expected = std::clamp(distanceToHole(photo, x, y) / blendPixels, 0.0, 1.0);
            EXPECT_NEAR(fade.weightAt(x, y), expected, 1e-5) << x << ", " << y;
        }
}

TEST(HoleFeather, LeavesPhotosWithoutHolesAlone) {
    EXPECT_TRUE(holeFeather(plainPhoto(grey)->image, 24).faded.empty());
    EXPECT_TRUE(holeFeather(tallPhoto()->image, 0).faded.empty());
}

TEST(HoleFeather, TakesAPhotoOfHolesAlone) {
    const PhotoFade fade = holeFeather(plainPhoto(nothing)->image, 24);
    EXPECT_EQ(fade.weightAt(4, 4), 0);
}

/// A slanted edge over triangles of many sizes: what was erased passes into what lies beneath without a step,
/// which is there without a border.
TEST(HoleFeather, LeavesNoStepOnTheOrganWhereAPhotoWasErased) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    const Atlas atlas = packAtlas(mesh, {512, 1, 4, AtlasLayout::UnfoldedGroups});
    TextureLayer layer = layerFromAbove(
        makePhoto(400, 400, [](int x, int y) { return x + 0.4 * y < 280 ? nothing : grey; }), 0.3);
    layer.projector.occlusion = false;
    layer.prepared = pictureOf(layer); // as if its field had been found
    const auto seamOf = [&](double blendPixels) {
        layer.blendPixels = blendPixels;
        return seamError(mesh, atlas, composite(mesh, atlas, {layer}, baseColour));
    };
    EXPECT_LE(seamOf(48), 8);
    EXPECT_GT(seamOf(0), 14);
}

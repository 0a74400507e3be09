#include "core/texture/layers/composite.h"
#include "core/texture/layers/mask_feather.h"
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

/// Pixels from a place to the side of the nearest pixel that is masked, looked for one by one.
double distanceToMask(const Image& photo, int x, int y) {
    double nearest = 1e9;
    for (int row = 0; row < photo.height; ++row)
        for (int column = 0; column < photo.width; ++column)
            if (photo.at(column, row)[3] == 0)
                nearest = std::min(nearest, std::hypot(column + 0.5 - x, row + 0.5 - y) - 0.5);
    return nearest;
}

} // namespace

TEST(MaskFeather, FadesLinearlyTowardsWhatIsMasked) {
    const Image photo = tallPhoto()->image;
    constexpr double blendPixels = 32;
    const PhotoFade fade = maskFeather(photo, blendPixels);
    ASSERT_EQ(fade.spacing, 4);
    for (int y = 0; y < photo.height; y += 12)
        for (int x = 0; x < photo.width; x += 12) {
            const double expected = std::clamp(distanceToMask(photo, x, y) / blendPixels, 0.0, 1.0);
            EXPECT_NEAR(fade.weightAt(x, y), expected, 0.5 / blendPixels) << x << ", " << y;
        }
}

TEST(MaskFeather, LeavesPhotosWithoutAMaskAlone) {
    EXPECT_TRUE(maskFeather(plainPhoto(grey)->image, 24).faded.empty());
    EXPECT_TRUE(maskFeather(tallPhoto()->image, 0).faded.empty());
}

TEST(MaskFeather, TakesAPhotoOfWhichNothingIsShown) {
    const PhotoFade fade = maskFeather(plainPhoto(nothing)->image, 24);
    EXPECT_EQ(fade.weightAt(4, 4), 0);
}

TEST(MaskFeather, TakesPhotosOfOnePixelAndBordersWiderThanAnyPhoto) {
    const Image dot = makePhoto(1, 1, [](int, int) { return nothing; })->image;
    EXPECT_EQ(maskFeather(dot, 24).weightAt(0.5, 0.5), 0);
    const Image line = makePhoto(1, 200, [](int, int y) { return y < 5 ? nothing : grey; })->image;
    EXPECT_NEAR(maskFeather(line, 100).weightAt(0.5, 55), 0.5, 0.01);
    for (const double blendPixels : {1e4, 1e12, 1e30}) {
        const double weight = maskFeather(tallPhoto()->image, blendPixels).weightAt(80, 100);
        EXPECT_GE(weight, 0) << blendPixels;
        EXPECT_LT(weight, 0.02) << blendPixels;
    }
}

TEST(MaskFeather, IsAskedOfPhotosThatPreparingLeavesPartsOutOf) {
    TextureLayer layer = layerFromAbove(plainPhoto(nothing), 0.1);
    EXPECT_FALSE(fadesAtMask(layer)) << "transparent as its file is";
    PhotoPreparation preparation;
    preparation.evenLight = 1;
    prepare(layer, preparation);
    EXPECT_FALSE(fadesAtMask(layer));
    preparation.crop = PhotoCrop{0, 0, 4, 4};
    prepare(layer, preparation);
    EXPECT_TRUE(fadesAtMask(layer));
    layer.blending = Blending::MultiBand;
    EXPECT_FALSE(fadesAtMask(layer));
}

/// A slanted edge over triangles of many sizes: what was erased passes into what lies beneath without a step,
/// which is there without a border.
TEST(MaskFeather, LeavesNoStepOnTheOrganWhereAPhotoWasErased) {
    const TriangleMesh mesh = lumpySurface(40, 60);
    const Atlas atlas = packAtlas(mesh, {512, 1, 4, AtlasLayout::UnfoldedGroups});
    TextureLayer layer = layerFromAbove(
        makePhoto(400, 400, [](int x, int y) { return x + 0.4 * y < 280 ? nothing : grey; }), 0.3);
    layer.projector.occlusion = false;
    layer.prepared = pictureOf(layer);
    layer.preparation.crop = PhotoCrop{0, 0, 400, 400}; // as if it had left that out
    const auto seamOf = [&](double blendPixels) {
        layer.blendPixels = blendPixels;
        return seamError(mesh, atlas, composite(mesh, atlas, {layer}, baseColour));
    };
    EXPECT_LE(seamOf(48), 8);
    EXPECT_GT(seamOf(0), 14);
}

#include "core/texture/layers/multi_band.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <tbb/global_control.h>

using namespace esm;
using namespace esm::test;

namespace {

constexpr int size = 200;

/// Pixels over which the coarsest band fades: four times its own pixels, which are as often doubled as a
/// quarter of the photo has room for.
constexpr double widestBorder = 32;
constexpr double rounding = 0.5; ///< of a pixel's value

/// Grey around `mean` with stripes two pixels wide that differ by `detail` from it.
std::shared_ptr<const Photo> stripes(int mean, int detail) {
    return makePhoto(size, size, [=](int x, int) {
        const auto value = static_cast<std::uint8_t>(mean + (x / 2 % 2 == 0 ? detail : -detail));
        return Colour{value, value, value, 255};
    });
}

Image inBands(const Image& photo, const Image& beneath) {
    return blendedInBands(photo, PhotoSampler(photo), beneath, {}, 24);
}

TextureLayer banded(std::shared_ptr<const Photo> photo, double width) {
    TextureLayer layer = layerFromAbove(std::move(photo), width);
    layer.blending = Blending::MultiBand;
    return layer;
}

} // namespace

TEST(MultiBand, ChangesNothingWhereBothAreTheSame) {
    const Image photo = stripes(120, 20)->image;
    EXPECT_EQ(inBands(photo, photo).pixels, photo.pixels);
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    const TextureLayer below = layerFromAbove(stripes(120, 20), 0.08);
    const Image without = composite(mesh, atlas, {below}, baseColour).front();
    const Image with = composite(mesh, atlas, {below, banded(stripes(120, 20), 0.08)}, baseColour).front();
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        ASSERT_NEAR(int(with.pixels[i]), int(without.pixels[i]), 1);
}

TEST(MultiBand, PassesFromOneColourIntoAnotherByItsDefinition) {
    const Image blended = inBands(stripes(90, 0)->image, stripes(150, 0)->image);
    for (int x = 0; x < size / 2; ++x) {
        const double t = std::min(1.0, (x + 0.5) / widestBorder);
        ASSERT_NEAR(int(blended.at(x, size / 2)[0]), 90 + 60 * (1 - t * t * (3 - 2 * t)), rounding + 0.01)
            << x;
        ASSERT_EQ(blended.at(x, size / 2)[0], blended.at(size - 1 - x, size / 2)[0]);
        ASSERT_EQ(blended.at(x, size / 2)[0], blended.at(size / 2, x)[0]);
    }
}

TEST(MultiBand, KeepsDetailUpToItsOwnNarrowBorder) {
    const Image photo = stripes(90, 20)->image, plain = stripes(90, 0)->image,
                beneath = stripes(150, 0)->image;
    const Image blended = inBands(photo, beneath), ramp = inBands(plain, beneath);
    // Stripes of a period of four pixels lie in the two finest bands, the wider of which fades over eight.
    constexpr int narrow = 8;
    for (int x = narrow; x + narrow < size; ++x)
        ASSERT_NEAR(blended.at(x, size / 2)[0] - ramp.at(x, size / 2)[0], photo.at(x, size / 2)[0] - 90, 3)
            << x;
    EXPECT_NEAR(int(blended.at(0, size / 2)[0]), 150, 4) << "at the border it is what lies beneath";
}

TEST(MultiBand, LeavesNoStepOnTheSurface) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    const auto largestAtBorder = [&](Blending blending) {
        TextureLayer layer = layerFromAbove(plainPhoto({90, 90, 90, 255}), 0.06);
        layer.photo = stripes(90, 0);
        layer.blending = blending;
        int largest = 0;
        forEachTexelInside(mesh, atlas, composite(mesh, atlas, {layer}, {150, 150, 150}),
                           [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                               const double inside =
                                   0.03 - std::max(std::abs(point.x()), std::abs(point.y()));
                               if (inside > 0 && inside < 0.0005)
                                   largest = std::max(largest, 150 - int(colour[0]));
                           });
        return largest;
    };
    EXPECT_EQ(largestAtBorder(Blending::Normal), 60);
    // 0.5 mm are 1.7 pixels of the photo.
    const double t = 0.0005 / 0.06 * size / widestBorder;
    EXPECT_LE(largestAtBorder(Blending::MultiBand), 60 * t * t * (3 - 2 * t) + 2 * rounding);
}

TEST(MultiBand, PassesIntoWhatLiesBeneathWhereItIsErased) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = banded(stripes(90, 0), 0.08);
    BrushStroke stroke; // a hard one from top to bottom, x from -0.005 to 0.005 m
    stroke.radius = 0.005;
    stroke.softness = 0;
    stroke.path = {{{0, -0.06, 0}, Eigen::Vector3d::UnitZ()}, {{0, 0.06, 0}, Eigen::Vector3d::UnitZ()}};
    layer.strokes = {std::make_shared<const BrushStroke>(stroke)};
    constexpr double pixelsPerMetre = size / 0.08;
    std::size_t compared = 0;
    forEachTexelInside(mesh, atlas, composite(mesh, atlas, {layer}, {150, 150, 150}),
                       [&](const Eigen::Vector3d& point, const Colour& colour, std::size_t) {
                           const double inside = (std::abs(point.x()) - stroke.radius) * pixelsPerMetre;
                           if (std::abs(point.y()) > 0.02 || inside > widestBorder) return;
                           ++compared;
                           const double t = std::max(0.0, inside / widestBorder);
                           // The mask's border is known to a pixel, over which the colour changes by 2.8.
                           ASSERT_NEAR(int(colour[0]), 90 + 60 * (1 - t * t * (3 - 2 * t)), 4) << point.x();
                       });
    EXPECT_GT(compared, 10000U);
}

TEST(MultiBand, IsNotChangedByAStrokeThatReachesNothing) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    TextureLayer layer = banded(stripes(90, 20), 0.16); // wider than the surface
    const std::vector<Image> before = composite(mesh, atlas, {layer}, {150, 150, 150});
    BrushStroke stroke;
    stroke.path = {{{5, 0, 0}, Eigen::Vector3d::UnitZ()}};
    layer.strokes = {std::make_shared<const BrushStroke>(stroke)};
    EXPECT_EQ(composite(mesh, atlas, {layer}, {150, 150, 150}).front().pixels, before.front().pixels);
}

TEST(MultiBand, LeavesWhatIsTransparentAndWhatNothingLiesBeneath) {
    Image photo = stripes(90, 20)->image, beneath = stripes(150, 0)->image;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size / 2; ++x)
            photo.at(x, y)[3] = beneath.at(size - 1 - x, y)[3] = 0;
    const Image blended = inBands(photo, beneath);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            ASSERT_EQ(blended.at(x, y)[3], photo.at(x, y)[3]);
    EXPECT_EQ(blended.pixels, photo.pixels) << "nowhere are both known";
}

TEST(MultiBand, IsTheSameWithAnyNumberOfThreads) {
    const TriangleMesh mesh = lumpySurface(30, 40);
    const Atlas atlas = packAtlas(mesh, {512, 1, 2});
    const std::vector<TextureLayer> layers{layerFromAbove(checkerboard(), 0.15), banded(stripes(90, 20), 0.1),
                                           banded(stripes(200, 30), 0.12)};
    const auto composeWith = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return composite(mesh, atlas, layers, baseColour).front().pixels;
    };
    EXPECT_EQ(composeWith(1), composeWith(2));
}

TEST(MultiBand, ComparesLargePhotosInASmallerSize) {
    EXPECT_EQ(comparedSize({4001, 3000}).width, 1001);
    EXPECT_EQ(comparedSize({4001, 3000}).height, 750);
    EXPECT_EQ(comparedSize({1024, 10}).width, 1024);
}

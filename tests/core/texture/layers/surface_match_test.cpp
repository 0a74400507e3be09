#include "core/texture/layers/surface_match.h"

#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

using namespace esm;
using namespace esm::test;

namespace {

/// A bluish photo that varies.
std::shared_ptr<const Photo> bluishPhoto() {
    return makePhoto(128, 128, [](int x, int y) {
        const auto wave = static_cast<std::uint8_t>((x * 7 + y * 13) % 40);
        return Colour{static_cast<std::uint8_t>(60 + wave), static_cast<std::uint8_t>(80 + wave),
                      static_cast<std::uint8_t>(150 + wave), 255};
    });
}

std::array<double, 3> meanColour(const Image& image) {
    std::array<double, 3> mean{};
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (i % 4 < 3) mean[i % 4] += 4.0 * image.pixels[i] / static_cast<double>(image.pixels.size());
    return mean;
}

} // namespace

TEST(SurfaceMatch, GivesAPhotoTheColourOfWhatLiesBeneath) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    TextureLayer layer = layerFromAbove(bluishPhoto(), 0.08);
    const auto match = matchToSurface(mesh, {}, baseColour, layer);
    ASSERT_TRUE(match);
    PhotoPreparation preparation;
    preparation.match = match;
    prepare(layer, preparation);
    const auto mean = meanColour(*layer.prepared);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(mean[i], baseColour[i], 4) << i;
    // Found anew, it does not go on from itself.
    EXPECT_EQ(matchToSurface(mesh, {}, baseColour, layer), match);
}

TEST(SurfaceMatch, GoesByTheLayersBeneath) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    const TextureLayer layer = layerFromAbove(bluishPhoto(), 0.08);
    const auto toItself = matchToSurface(mesh, {layer}, baseColour, layer);
    ASSERT_TRUE(toItself);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(toItself->scale[i], 1, 0.05);
        EXPECT_NEAR(toItself->offset[i], 0, 3);
    }
}

TEST(SurfaceMatch, IsNoneWhereThePhotoMeetsNoSurface) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    TextureLayer layer = layerFromAbove(bluishPhoto(), 0.08);
    layer.projector.pose.translation().x() += 1;
    EXPECT_FALSE(matchToSurface(mesh, {}, baseColour, layer));
}

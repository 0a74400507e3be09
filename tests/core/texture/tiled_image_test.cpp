#include "core/texture/tiled_image.h"

#include <gtest/gtest.h>

using namespace esm;

namespace {

constexpr TileSize tile{8, 4};

Image numbered(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < 4 * width * height; ++i)
        image.pixels.push_back(static_cast<std::uint8_t>(i * 7));
    return image;
}

} // namespace

TEST(TiledImage, GivesItsPictureBack) {
    for (const auto& [width, height] : {std::pair{8, 4}, {16, 12}, {21, 10}, {1, 1}}) {
        const Image image = numbered(width, height);
        const TiledImage tiles(image, tile);
        EXPECT_EQ(tiles.image().pixels, image.pixels) << width << " x " << height;
        EXPECT_EQ(tiles.columns(), (width + 7) / 8);
        EXPECT_EQ(tiles.at(width - 1, height - 1)[1], image.at(width - 1, height - 1)[1]);
    }
    EXPECT_TRUE(TiledImage().empty());
}

TEST(TiledImage, OfOneColourIsOneTile) {
    const TiledImage image(21, 10, tile, {1, 2, 3, 4});
    EXPECT_EQ(&image.tile(0, 0), &image.tile(2, 2));
    EXPECT_EQ(image.at(20, 9)[2], 3);
}

TEST(TiledImage, KeepsTheTilesInWhichNothingIsPainted) {
    const TiledImage before(numbered(21, 10), tile);
    TiledImage after = before;
    EXPECT_TRUE(after.isLike(before));
    TileRowPainter painter(after, 1);
    const PixelRun first = painter.run(6, 20, 5);
    EXPECT_EQ(first.count, 2) << "up to the tile's end";
    first.pixels[0] = 99;
    painter.run(6, 20, 5).pixels[4] = 98;
    EXPECT_EQ(after.at(6, 5)[0], 99);
    EXPECT_EQ(after.at(7, 5)[0], 98) << "what was painted there before stays";
    EXPECT_EQ(before.image().pixels, numbered(21, 10).pixels);
    EXPECT_FALSE(after.sharesTile(before, 0, 1));
    EXPECT_TRUE(after.sharesTile(before, 1, 1));
    EXPECT_TRUE(after.sharesTile(before, 0, 0));
}

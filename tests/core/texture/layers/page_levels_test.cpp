#include "core/texture/layers/page_levels.h"

#include "core/support/errors.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/patch_scan.h"
#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/test_surfaces.h"

#include <cmath>

using namespace esm;
using namespace esm::test;

namespace {

/// A colour of its own for so many triangles.
Colour colourOf(std::size_t triangle) {
    return {std::uint8_t(37 * (triangle + 1)), std::uint8_t(91 * (triangle + 1)), std::uint8_t(53 * triangle),
            255};
}

/// Every texel in the colour of the triangle whose patch is nearest, told by each texel's own search.
Image pageInTriangleColours(const Atlas& atlas) {
    Image page;
    page.width = page.height = atlas.options.size;
    page.pixels.assign(4 * std::size_t(page.width) * std::size_t(page.height), 0);
    std::vector<double> nearest(std::size_t(page.width) * std::size_t(page.height), 1e9);
    const PageStrip whole{0, 0, page.height, {}};
    for (std::size_t i = 0; i < atlas.corners.size(); ++i)
        PatchScan(atlas.corners[i]).forEachTexel(whole, page.width, 64, [&](const PatchTexel& texel) {
            double& distance = nearest[std::size_t(texel.y) * std::size_t(page.width) + std::size_t(texel.x)];
            if (texel.distance >= distance) return;
            distance = texel.distance;
            const Colour colour = colourOf(i);
            std::copy(colour.begin(), colour.end(), page.at(texel.x, texel.y));
        });
    return page;
}

} // namespace

TEST(PageLevels, AreAsManyAsTheGapSupports) {
    const auto levels = [](int size, int gap) { return usableLevels({size, 1, gap}); };
    EXPECT_EQ(usableLevels({1024, 1, 16, AtlasLayout::Own}), 0) << "where nobody keeps a gap";
    EXPECT_EQ(usableLevels({1024, 1, 16, AtlasLayout::Charts}), 3) << "as where triangles lie alone";
    EXPECT_EQ(levels(1024, 2), 0);
    EXPECT_EQ(levels(1024, 4), 1);
    EXPECT_EQ(levels(1024, 8), 2);
    EXPECT_EQ(levels(1024, 16), 3);
    EXPECT_EQ(levels(1000, 64), 3) << "an eighth of the size is the last whole number";
    EXPECT_LE(levels(16384, 4096), 5);
}

TEST(PageLevels, ShowEachTriangleInItsOwnColourAlone) {
    const TriangleMesh mesh = flatSquare(0.1, 4);
    // Where triangles lie side by side as on the surface, they mix: see the next test.
    for (const AtlasLayout layout : {AtlasLayout::Rows, AtlasLayout::MatchedRows}) {
        AtlasOptions options{512, 1, 8};
        options.layout = layout;
        const Atlas atlas = packAtlas(mesh, options);
        const std::vector<Image> pages{pageInTriangleColours(atlas)};
        const auto smaller = smallerPages(mesh, atlas, tiled(pages));
        ASSERT_EQ(smaller.size(), 1U);
        ASSERT_EQ(smaller[0].size(), 2U);
        for (int level = 1; level <= 2; ++level) {
            const Image page = smaller[0][std::size_t(level - 1)].image();
            ASSERT_EQ(page.width, 512 >> level);
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                // Texels whose centres lie in the patch: never a mixture, though their blocks reach beyond
                // it.
                PatchScan patch({atlas.corners[i][0] / (1 << level), atlas.corners[i][1] / (1 << level),
                                 atlas.corners[i][2] / (1 << level)});
                patch.forEachTexel({0, 0, page.height, {}}, page.width, 0.1, [&](const PatchTexel& texel) {
                    if (texel.distance > 0) return;
                    ASSERT_EQ(pixelAt(page, texel.x, texel.y), colourOf(i)) << "level " << level;
                });
            }
        }
    }
}

TEST(PageLevels, KeepSeamsUnseenOnASmoothPhoto) {
    const TriangleMesh mesh = flatSquare(0.1, 6);
    // It changes by about one level from texel to texel at a quarter of the size.
    const auto photo = makePhoto(1024, 1024, [](int x, int y) {
        const auto wave = [](double at) {
            return std::uint8_t(std::lround(127 + 40 * std::sin(at * 2 * M_PI / 1024)));
        };
        return Colour{wave(x), wave(y), wave(0.7 * (x + y)), 255};
    });
    for (const AtlasLayout layout : atlasLayouts) {
        const Atlas atlas = packAtlas(mesh, {1024, 1, 8, layout});
        const std::vector<Image> pages = composite(mesh, atlas, {layerFromAbove(photo, 0.11)}, baseColour);
        const auto smaller = smallerPages(mesh, atlas, tiled(pages));
        EXPECT_LE(seamError(mesh, atlas, pages), 2) << wordOf(layout);
        for (int level = 1; level <= 2; ++level)
            EXPECT_LE(seamError(mesh, atlas, {smaller[0][std::size_t(level - 1)].image()}, level), 2)
                << wordOf(layout) << ' ' << level;
    }
}

/// Triangles of a few texels, black and white in turn: seen small, they are grey.
TEST(PageLevels, MixTrianglesThatLieSideBySideAsOnTheSurface) {
    const TriangleMesh mesh = flatSquare(0.1, 40);
    const Atlas atlas = packAtlas(mesh, {256, 1, 8, AtlasLayout::Charts});
    Image page = pageInTriangleColours(atlas);
    for (std::uint8_t& value : page.pixels)
        value = value % 2 == 0 ? 0 : 255; // the first channel is odd for every other triangle
    const Image small = smallerPages(mesh, atlas, tiled({page}))[0][1].image();
    const PageStrip whole{0, 0, small.height, {}};
    std::size_t grey = 0, all = 0;
    for (const auto& corners : atlas.corners)
        PatchScan({corners[0] / 4, corners[1] / 4, corners[2] / 4})
            .forEachTexel(whole, small.width, 0.1, [&](const PatchTexel& texel) {
                if (texel.distance > 0) return;
                const int shade = small.at(texel.x, texel.y)[0];
                grey += shade > 40 && shade < 215 ? 1 : 0;
                ++all;
            });
    ASSERT_GT(all, 500U);
    EXPECT_GT(double(grey), 0.9 * double(all));
}

TEST(PageLevels, ReadNothingButFilledTexelsHoweverWideTheGap) {
    const TriangleMesh mesh = flatSquare(0.1, 2);
    for (const int gap : {4, 16, 64, 128}) {
        const Atlas atlas = packAtlas(mesh, {2048, 1, gap});
        const std::vector<Image> pages =
            composite(mesh, atlas, {layerFromAbove(plainPhoto(green), 0.3)}, baseColour);
        const auto smaller = smallerPages(mesh, atlas, tiled(pages));
        for (int level = 1; level <= usableLevels(atlas.options); ++level)
            EXPECT_LT(seamError(mesh, atlas, {smaller[0][std::size_t(level - 1)].image()}, level), 0.5)
                << gap << ' ' << level;
    }
}

TEST(PageLevels, ComputeOnlyWhatChangedWithTheSameResult) {
    const TriangleMesh mesh = flatSquare(0.1, 6);
    const Atlas atlas = packAtlas(mesh, {512, 1, 8});
    CompositionCache cache;
    const auto before =
        std::make_shared<const TiledPages>(recomposite(mesh, atlas, {}, {}, baseColour, cache));
    const TiledPages now = recomposite(mesh, atlas, {{}, baseColour, before},
                                       {layerFromAbove(plainPhoto(green), 0.03)}, baseColour, cache);
    const auto whole = smallerPages(mesh, atlas, now);
    const auto halved = smallerPages(mesh, atlas, *before);
    const auto changed = smallerPages(atlas, TexelOwners(mesh, atlas), now, {*before, halved});
    for (std::size_t level = 0; level < 2; ++level) {
        EXPECT_EQ(changed[0][level].image().pixels, whole[0][level].image().pixels);
        EXPECT_TRUE(changed[0][level].sharesTile(halved[0][level], 0, 0)) << "where nothing was laid";
    }
}

TEST(PageLevels, RefuseForeignPages) {
    const TriangleMesh mesh = flatSquare(0.1, 2);
    const Atlas atlas = packAtlas(mesh, {256, 1, 8});
    Image small;
    small.width = small.height = 16;
    small.pixels.resize(4 * 16 * 16);
    EXPECT_THROW(smallerPages(mesh, atlas, tiled({small})), InvalidModel);
    EXPECT_THROW(smallerPages(mesh, atlas, {}), InvalidModel);
}

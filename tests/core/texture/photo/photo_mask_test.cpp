#include "core/texture/photo/photo_mask.h"

#include "core/geometry/segment_distance.h"
#include "core/texture/photo/outline_cover.h"
#include "core/texture/photo/region_growing.h"
#include "core/texture/photo/stroke_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace esm;

namespace {

Image whitePhoto(int width, int height) {
    Image image{width, height, {}};
    image.pixels.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
    return image;
}

/// A path of places that lie where they fall, some of them twice.
PhotoStroke scribble(std::mt19937& random, int places) {
    std::uniform_real_distribution<double> within(-30, 180), share(0, 1);
    PhotoStroke stroke;
    stroke.radius = 0.5 + 40 * share(random) * share(random);
    stroke.softness = share(random);
    for (int i = 0; i < places; ++i)
        stroke.path.emplace_back(within(random), within(random));
    stroke.path.push_back(stroke.path.back());
    return stroke;
}

/// Asked of every segment.
float plainCover(const PhotoStroke& stroke, int x, int y) {
    double nearest = 1e9;
    for (std::size_t i = 0; i + 1 < stroke.path.size(); ++i)
        nearest =
            std::min(nearest, distanceToSegment({x + 0.5, y + 0.5}, stroke.path[i], stroke.path[i + 1]));
    const double fade = std::max(1.0, stroke.softness * stroke.radius);
    return static_cast<float>(std::clamp((stroke.radius + 0.5 - nearest) / fade, 0.0, 1.0));
}

} // namespace

TEST(PhotoMask, CoversByTheNearestOfManySegments) {
    std::mt19937 random(5);
    for (const int places : {1, 2, 7, 60, 400}) {
        const PhotoStroke stroke = scribble(random, places);
        const StrokeCover cover = coverOf(stroke, {0, 0, 149, 129});
        for (int y = 0; y < 130; ++y)
            for (int x = 0; x < 150; ++x) {
                const PixelRange& range = cover.range;
                const bool isWithin =
                    x >= range.left && x <= range.right && y >= range.top && y <= range.bottom;
                ASSERT_EQ(isWithin ? cover.at(x, y) : 0, plainCover(stroke, x, y))
                    << places << ": " << x << ' ' << y;
            }
    }
}

TEST(PhotoMask, CoversTheInsideOfAnOutlineRowByRow) {
    std::mt19937 random(6);
    const PhotoStroke stroke = scribble(random, 50);
    const std::vector<float> cover = coverOf(stroke.path, 150, 130);
    for (int y = 0; y < 130; ++y) {
        const std::vector<float> row = rowCoverOf(stroke.path, 150, y);
        ASSERT_TRUE(std::equal(row.begin(), row.end(), cover.begin() + 150 * y)) << y;
    }
}

TEST(PhotoMask, LeavesOutWhatTheBrushTouches) {
    Image photo = whitePhoto(100, 60);
    maskStrokes(photo, {{{{20, 30}, {70, 30}}, 8, 0, false}});
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x) {
            const double px = x + 0.5, distance = std::hypot(px - std::clamp(px, 20.0, 70.0), y + 0.5 - 30);
            const int alpha = photo.at(x, y)[3];
            EXPECT_TRUE(distance > 7.49 || alpha == 0) << x << ' ' << y;
            EXPECT_TRUE(distance < 8.51 || alpha == 255) << x << ' ' << y;
            EXPECT_EQ(photo.at(x, y)[0], 255);
        }
}

TEST(PhotoMask, ASoftBrushFadesAndDoesNotAddUpAlongItsPath) {
    Image dab = whitePhoto(100, 100), there = dab;
    maskStrokes(dab, {{{{50, 50}}, 40, 1, false}});
    // To and fro over one place covers it once.
    maskStrokes(there, {{{{50, 50}, {50.1, 50}, {50, 50}}, 40, 1, false}});
    EXPECT_LT(dab.at(50, 50)[3], 4);
    EXPECT_NEAR(dab.at(70, 50)[3], 128, 4);
    EXPECT_EQ(dab.at(95, 50)[3], 255);
    for (int x = 0; x < 100; ++x)
        EXPECT_NEAR(there.at(x, 50)[3], dab.at(x, 50)[3], 2);
}

TEST(PhotoMask, TakesBackInOrderAndNoMoreThanThePhotoHas) {
    Image photo = whitePhoto(40, 40);
    for (int y = 0; y < 40; ++y)
        photo.at(20, y)[3] = 100;
    const PhotoStroke out{{{20, 20}}, 10, 0, false}, back{{{20, 20}}, 5, 0, true};
    Image both = photo, wrong = photo;
    maskStrokes(both, {out, back});
    maskStrokes(wrong, {back, out});
    EXPECT_EQ(both.at(20, 20)[3], 100);
    EXPECT_EQ(both.at(19, 20)[3], 255);
    EXPECT_EQ(both.at(19, 12)[3], 0);
    EXPECT_EQ(wrong.at(19, 20)[3], 0);
}

TEST(PhotoMask, MayLeaveThePhoto) {
    Image photo = whitePhoto(30, 20);
    const Image before = photo;
    maskStrokes(photo, {{{{-500, -500}}, 20, 0.5, false}, {{{1e7, 5}}, 20, 0.5, false}});
    EXPECT_EQ(photo.pixels, before.pixels);
    maskStrokes(photo, {{{{-50, 10}, {80, 10}}, 5, 0, false}});
    EXPECT_EQ(photo.at(0, 10)[3], 0);
    EXPECT_EQ(photo.at(29, 10)[3], 0);
    EXPECT_EQ(photo.at(15, 1)[3], 255);
}

TEST(PhotoMask, AnOutlineLeavesOutItsInside) {
    Image photo = whitePhoto(100, 60);
    const PhotoStroke box{{{20.5, 10.5}, {79.5, 10.5}, {79.5, 49.5}, {20.5, 49.5}}, 0.5, 0, false, true};
    const PhotoStroke hole{{{40.5, 20.5}, {59.5, 20.5}, {59.5, 39.5}, {40.5, 39.5}}, 0.5, 0, true, true};
    maskStrokes(photo, {box, hole});
    EXPECT_EQ(photo.at(30, 30)[3], 0);
    EXPECT_EQ(photo.at(20, 10)[3], 0);
    EXPECT_EQ(photo.at(79, 49)[3], 0);
    EXPECT_EQ(photo.at(18, 30)[3], 255);
    EXPECT_EQ(photo.at(50, 30)[3], 255);
}

TEST(PhotoMask, AnOutlineThatCrossesItselfLeavesAllInsideOut) {
    Image photo = whitePhoto(60, 60);
    // Twice around the middle, as a hand does that draws on past its beginning.
    maskStrokes(photo, {{{{10, 10}, {50, 10}, {50, 50}, {10, 50}, {15, 15}, {45, 15}, {45, 45}, {15, 45}},
                         0.5,
                         0,
                         false,
                         true}});
    EXPECT_EQ(photo.at(30, 30)[3], 0);
    EXPECT_EQ(photo.at(5, 30)[3], 255);
}

TEST(RegionGrowing, OutlinesAnInstrumentWithItsHoles) {
    Image photo = whitePhoto(80, 60);
    const auto isSteel = [](int x, int y) {
        return x > 20 && x < 60 && y > 10 && y < 50 && std::hypot(x - 40, y - 30) > 8;
    };
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const int level = isSteel(x, y) ? 90 + y : 0;
            const std::array<int, 3> colour{isSteel(x, y) ? level : 170, isSteel(x, y) ? level : 60,
                                            isSteel(x, y) ? level : 50};
            std::copy(colour.begin(), colour.end(), photo.at(x, y));
        }
    Image masked = photo;
    maskStrokes(masked, growRegion(photo, {25, 15}, 15));
    int wrong = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            wrong += (masked.at(x, y)[3] < 128) != isSteel(x, y) ? 1 : 0;
    EXPECT_LT(wrong, 40);
    EXPECT_TRUE(growRegion(photo, {-1, 5}, 15).empty());
    EXPECT_TRUE(growRegion(masked, {25, 15}, 15).empty());
}

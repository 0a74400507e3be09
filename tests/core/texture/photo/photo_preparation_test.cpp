#include "core/texture/photo/photo_preparation.h"

#include "core/support/errors.h"
#include "core/texture/layers/texture_layer.h"
#include "tests/core/texture/photo/drawn_photo.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace esm;

namespace {

Lens bentLens(LensKind kind) {
    return kind == LensKind::Pinhole ? Lens{kind, {300, 300, 322, 238}, {-0.25, 0.05, 0.002, -0.001, 0}}
                                     : Lens{kind, {300, 300, 322, 238}, {-0.02, 0.01, 0, 0, 0}};
}

/// The column at which a bright line crosses a row, by its centre of gravity near `about`.
double lineAt(const Image& image, int row, double about) {
    double sum = 0, weight = 0;
    for (int x = static_cast<int>(about) - 9; x <= static_cast<int>(about) + 9; ++x) {
        const double bright = image.at(x, row)[0];
        sum += bright * (x + 0.5);
        weight += bright;
    }
    return weight > 0 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

TEST(PhotoPreparation, ThatDoesNothingChangesNoBit) {
    const Image photo = drawnPhoto(37, 21, [](int x, int y) -> Channels {
        return {scattered(x, y, 255), scattered(y, x, 255), 255, scattered(x + y, x, 255)};
    });
    EXPECT_TRUE(PhotoPreparation().isNothing());
    EXPECT_EQ(prepared(photo, {}).pixels, photo.pixels);
}

TEST(PhotoPreparation, NamesEveryProblem) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    PhotoPreparation bad;
    bad.field = PhotoField::circle({nan, 0}, 10, 95);
    bad.highlightThreshold = 0;
    bad.evenLight = nan;
    bad.whiteBalance = ColourGains{1, nan, 1};
    bad.lens = Lens{LensKind::Pinhole, {0, 1, nan, 0}, {1e9, 0, 0, 0, 0}};
    bad.strokes = {PhotoStroke{{{1, nan}}, 0, 2, false}};
    bad.match = ColourMatch{{0, 1, 1}, {0, nan, 0}};
    bad.crop = PhotoCrop{10, 0, std::numeric_limits<int>::max(), 5};
    bad.adjustment = {-1, nan, 0, 3, -1, 181};
    EXPECT_EQ(validate(bad, 100, 80).size(), 20U);
    EXPECT_THROW(prepared(drawnPhoto(4, 4, [](int, int) -> Channels { return {}; }), bad), InvalidModel);
    EXPECT_TRUE(validate({}, 100, 80).empty());
}

TEST(PhotoPreparation, IsTheSameWithAnyNumberOfThreads) {
    PhotoPreparation all;
    all.field = PhotoField::circle({320, 240}, 200);
    all.highlightSensitivity = 0.7;
    all.evenLight = 0.7;
    all.whiteBalance = ColourGains{0.9, 1, 1.1};
    all.strokes = {{{{100, 100}, {200, 150}}, 20, 0.5, false}};
    all.match = ColourMatch{{1.1, 0.9, 1}, {-5, 3, 2}};
    all.lens = bentLens(LensKind::Pinhole);
    all.crop = PhotoCrop{10, 10, 600, 400};
    all.adjustment = {5, 240, 1.2, 1.1, 0.9, -10};
    const Image photo = roundPhoto(320, 240, 210);
    const Image many = prepared(photo, all);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(prepared(photo, all).pixels, many.pixels);
}

TEST(PhotoPreparation, CropsExactly) {
    PhotoPreparation cropped;
    cropped.crop = PhotoCrop{3, 4, 5, 6};
    const Image photo = drawnPhoto(20, 20, [](int x, int y) -> Channels { return {x, y, 7, 200}; });
    const Image picture = prepared(photo, cropped);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            const bool kept = x >= 3 && x < 8 && y >= 4 && y < 10;
            EXPECT_EQ(colourOf(picture, x, y), (Channels{x, y, 7, kept ? 200 : 0}));
        }
}

TEST(PhotoPreparation, AdjustsColoursOfWhatAllElseLeaves) {
    PhotoPreparation all;
    all.field = PhotoField::circle({320, 240}, 200);
    all.whiteBalance = ColourGains{0.8, 1, 1.2};
    all.lens = bentLens(LensKind::Pinhole);
    const Image photo = roundPhoto(320, 240, 210);
    Image expected = prepared(photo, all);
    all.adjustment = {20, 200, 1.5, 1.2, 1.4, 30};
    const Image adjusted = prepared(photo, all);
    EXPECT_NE(adjusted.pixels, expected.pixels);
    adjustColours(expected, all.adjustment);
    EXPECT_EQ(adjusted.pixels, expected.pixels);
}

TEST(EvenLight, KeepsThePhotoAsBrightAndDoesNotSeeBlackAround) {
    const auto isInside = [](int x, int y) { return std::hypot(x - 320, y - 240) < 220; };
    Image photo = drawnPhoto(640, 480, [&](int x, int y) -> Channels {
        const int level = isInside(x, y) ? 60 + x / 5 : 0;
        return {level, level, level, 255};
    });
    const auto mean = [&](const Image& image) {
        double sum = 0, count = 0;
        for (int y = 0; y < 480; ++y)
            for (int x = 0; x < 640; ++x)
                if (isInside(x, y)) {
                    sum += image.at(x, y)[0];
                    ++count;
                }
        return sum / count;
    };
    const double before = mean(photo);
    evenLight(photo, 1);
    EXPECT_NEAR(mean(photo), before, 1.5);
    EXPECT_NEAR(photo.at(150, 240)[0], photo.at(490, 240)[0], 5);
}

TEST(EvenLight, TakesAVignetteAwayAndDoesNotSeeTheOutside) {
    const auto isInside = [](int x, int y) { return std::hypot(x - 320, y - 240) < 220; };
    Image photo = drawnPhoto(640, 480, [&](int x, int y) -> Channels {
        const double r = std::hypot(x - 320, y - 240) / 220;
        const int level = isInside(x, y) ? static_cast<int>(180 * (1 - 0.5 * r * r)) : 0;
        return {level, level, level, isInside(x, y) ? 255 : 0};
    });
    const auto spread = [&](const Image& image) {
        int least = 255, most = 0;
        for (int y = 0; y < 480; ++y)
            for (int x = 0; x < 640; ++x)
                if (isInside(x, y)) {
                    least = std::min<int>(least, image.at(x, y)[0]);
                    most = std::max<int>(most, image.at(x, y)[0]);
                }
        return static_cast<double>(most) / least;
    };
    EXPECT_NEAR(spread(photo), 2, 0.05);
    Image half = photo;
    evenLight(half, 0.5);
    evenLight(photo, 1);
    EXPECT_LT(spread(half), 1.55);
    EXPECT_LT(spread(photo), 1.25);
}

/// Light falls to the right as far as a hollow, where nothing but noise of single colours is left.
TEST(EvenLight, DoesNotBrightenTheNoiseOfTheDark) {
    const Image before = drawnPhoto(640, 480, [](int x, int y) -> Channels {
        const int light = x < 450 ? static_cast<int>(160 * std::exp(-x / 200.0)) : 3;
        const int noise = (7 * x + 13 * y) % 5;
        return {light + noise, light, light, 255};
    });
    Image after = before;
    evenLight(after, 1);
    for (int x = 500; x < 640; ++x)
        EXPECT_LE(std::abs(after.at(x, 100)[0] - before.at(x, 100)[0]), 3) << x;
    const auto fall = [](const Image& photo) { return double(photo.at(40, 100)[1]) / photo.at(200, 100)[1]; };
    EXPECT_LT(fall(after), 0.7 * fall(before)) << "what is dim is evened";
}

TEST(PhotoPreparation, CanBeCancelled) {
    const Image photo = roundPhoto(320, 240, 210);
    EXPECT_THROW(prepared(photo, {}, [](double) { return false; }), Cancelled);
}

TEST(Lens, StraightensLines) {
    for (const LensKind kind : {LensKind::Pinhole, LensKind::Fisheye}) {
        const Lens lens = bentLens(kind);
        // A vertical line of the straight picture, drawn where the lens would show its points.
        for (const double column : {122.0, 240.0, 480.0}) {
            Image photo = drawnPhoto(640, 480, [](int, int) -> Channels { return {0, 0, 0, 255}; });
            for (double y = -200; y < 680; y += 0.25) {
                const Eigen::Vector2d place = distorted(lens, {column, y});
                for (int x = static_cast<int>(place.x()) - 3; x <= static_cast<int>(place.x()) + 3; ++x) {
                    const int row = static_cast<int>(std::floor(place.y()));
                    if (row < 0 || row >= 480 || x < 0 || x >= 640) continue;
                    const double bright = 255 * std::max(0.0, 1 - std::abs(x + 0.5 - place.x()) / 2.5);
                    photo.at(x, row)[0] = static_cast<std::uint8_t>(bright);
                }
            }
            const Image straight = undistorted(photo, lens);
            EXPECT_EQ(straight.width, 640);
            for (int row = 60; row < 420; row += 20)
                EXPECT_NEAR(lineAt(straight, row, column), column, 0.5) << row;
        }
    }
}

TEST(Lens, WithoutDistortionKeepsThePhoto) {
    const Image photo = drawnPhoto(32, 24, [](int x, int y) -> Channels {
        return {scattered(x, y, 255), x, y, 255};
    });
    EXPECT_EQ(undistorted(photo, {LensKind::Pinhole, {30, 30, 16, 12}, {}}).pixels, photo.pixels);
}

#include "core/texture/photo/photo_preparation.h"

#include "core/support/errors.h"
#include "core/texture/layers/texture_layer.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace esm;

namespace {

using Channels = std::array<int, 4>;

Image drawnPhoto(int width, int height, const std::function<Channels(int, int)>& colourAt) {
    Image image;
    image.width = width;
    image.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int channel : colourAt(x, y))
                image.pixels.push_back(static_cast<std::uint8_t>(channel));
    return image;
}

Channels colourOf(const Image& image, int x, int y) {
    const std::uint8_t* p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
}

/// Numbers from 0 to `most` that look random and are the same everywhere.
int scattered(int x, int y, int most) {
    const auto mixed =
        static_cast<std::uint32_t>(x) * 2654435761U ^ static_cast<std::uint32_t>(y) * 2246822519U;
    return static_cast<int>((mixed ^ mixed >> 15) % static_cast<std::uint32_t>(most + 1));
}

Image roundPhoto(double cx, double cy, double radius) {
    return drawnPhoto(640, 480, [&](int x, int y) -> Channels {
        const bool inside = std::hypot(x + 0.5 - cx, y + 0.5 - cy) < radius;
        const bool instrument = std::abs(x - y) < 25 && x > cx; // dark, across the border
        const int level = inside && !instrument ? 60 + scattered(x, y, 90) : scattered(x, y, 6);
        return {level, level / 2, level / 3, 255};
    });
}

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
    bad.field = RoundField{{nan, 0}, 10, 95};
    bad.highlightThreshold = 0;
    bad.evenLight = nan;
    bad.whiteBalance = ColourGains{1, nan, 1};
    bad.lens = Lens{LensKind::Pinhole, {0, 1, nan, 0}, {1e9, 0, 0, 0, 0}};
    bad.strokes = {PhotoStroke{{{1, nan}}, 0, 2, false}};
    bad.match = ColourMatch{{0, 1, 1}, {0, nan, 0}};
    bad.crop = PhotoCrop{10, 0, std::numeric_limits<int>::max(), 5};
    EXPECT_EQ(validate(bad, 100, 80).size(), 14U);
    EXPECT_THROW(prepared(drawnPhoto(4, 4, [](int, int) -> Channels { return {}; }), bad), InvalidModel);
    EXPECT_TRUE(validate({}, 100, 80).empty());
}

TEST(PhotoPreparation, IsTheSameWithAnyNumberOfThreads) {
    PhotoPreparation all;
    all.field = RoundField{{320, 240}, 200, 2};
    all.highlightThreshold = 30;
    all.evenLight = 0.7;
    all.whiteBalance = ColourGains{0.9, 1, 1.1};
    all.strokes = {{{{100, 100}, {200, 150}}, 20, 0.5, false}};
    all.match = ColourMatch{{1.1, 0.9, 1}, {-5, 3, 2}};
    all.lens = bentLens(LensKind::Pinhole);
    all.crop = PhotoCrop{10, 10, 600, 400};
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

TEST(RoundField, IsFoundWhereItIs) {
    for (const auto& [cx, cy, radius] : {std::array<double, 3>{320.3, 236.8, 200.4}, {300, 260, 290.5}}) {
        const auto field = findRoundField(roundPhoto(cx, cy, radius));
        ASSERT_TRUE(field);
        EXPECT_NEAR(field->centre.x(), cx, 1);
        EXPECT_NEAR(field->centre.y(), cy, 1);
        EXPECT_NEAR(field->radius, radius, 1);
    }
}

TEST(RoundField, IsNotFoundWhereThereIsNone) {
    EXPECT_FALSE(findRoundField({}));
    EXPECT_FALSE(findRoundField(drawnPhoto(200, 100, [](int, int) -> Channels { return {}; })));
    EXPECT_FALSE(findRoundField(drawnPhoto(200, 100, [](int x, int y) -> Channels {
        return {scattered(x, y, 255), 90, 80, 255};
    })));
    EXPECT_FALSE(findRoundField(drawnPhoto(200, 160, [](int x, int y) -> Channels {
        const int level = x > 40 && x < 160 && y > 30 && y < 130 ? 150 : 0;
        return {level, level, level, 255};
    })));
}

TEST(RoundField, IsFoundInALaparoscopicPhoto) {
    ESM_SKIP_WITHOUT(sharedData("images/lap-liver-gallbladder.jpg"));
    const auto field = findRoundField(loadPhoto(sharedData("images/lap-liver-gallbladder.jpg"))->image);
    ASSERT_TRUE(field);
    // By eye: the field spans the columns 175 to 1581, and of its chords at the rows 0 and 1074 the half
    // lengths are 431 and 487, which puts its centre between the rows 555 and 568.
    EXPECT_NEAR(field->centre.x(), 878, 6);
    EXPECT_NEAR(field->centre.y(), 561, 7);
    EXPECT_NEAR(field->radius, 703, 6);
}

TEST(RoundField, IsFoundWithAGlowAroundIt) {
    Image photo = roundPhoto(320, 240, 200);
    for (int y = 0; y < photo.height; ++y)
        for (int x = 0; x < photo.width; ++x) {
            const double outside = std::hypot(x + 0.5 - 320, y + 0.5 - 240) - 203;
            if (outside < 0) continue;
            const int glow = std::max(0, 20 - static_cast<int>(outside / (x > 320 ? 4 : 2)));
            std::fill_n(photo.at(x, y), 3, static_cast<std::uint8_t>(glow));
        }
    const auto field = findRoundField(photo);
    ASSERT_TRUE(field);
    EXPECT_NEAR(field->radius, 200, 1);
}

TEST(RoundField, IsFoundInASinusPhoto) {
    ESM_SKIP_WITHOUT(sharedData("images/sinus-sfm/00004584.jpg"));
    const auto field = findRoundField(loadPhoto(sharedData("images/sinus-sfm/00004584.jpg"))->image);
    ASSERT_TRUE(field);
    // By eye: the field spans the columns 467 to 1522 at its widest, at the row 540.
    EXPECT_NEAR(field->centre.x(), 994, 6);
    EXPECT_NEAR(field->centre.y(), 540, 12);
    EXPECT_NEAR(field->radius, 527, 6);
}

TEST(RoundField, IsMaskedWithAnEdgeOfOnePixel) {
    Image photo = drawnPhoto(100, 100, [](int, int) -> Channels { return {9, 9, 9, 255}; });
    maskField(photo, {{50, 50}, 40, 10});
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double distance = std::hypot(x + 0.5 - 50, y + 0.5 - 50);
            const int alpha = photo.at(x, y)[3];
            EXPECT_TRUE(distance > 35.49 || alpha == 255);
            EXPECT_TRUE(distance < 36.51 || alpha == 0);
        }
}

TEST(Highlights, AreFilledFromTheirSurroundingsAndNothingElseChanges) {
    const Image photo = drawnPhoto(80, 60, [](int x, int y) -> Channels {
        if (std::hypot(x - 40, y - 30) < 5) return {255, 250, 252, 255};
        return {150 + scattered(x, y, 20), 60 + scattered(y, x, 20), 50, 255};
    });
    Image filled = photo;
    const std::size_t count = fillHighlights(filled, 235);
    std::size_t changed = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const Channels c = colourOf(filled, x, y);
            EXPECT_TRUE(std::hypot(x - 40, y - 30) <= 9 || c == colourOf(photo, x, y));
            EXPECT_TRUE(c[0] >= 148 && c[0] <= 172 && c[1] >= 58 && c[1] <= 82) << x << ' ' << y;
            changed += c != colourOf(photo, x, y) ? 1 : 0;
        }
    EXPECT_GE(count, changed);
    EXPECT_GE(count, 69U);
    Image white = drawnPhoto(8, 8, [](int, int) -> Channels { return {255, 255, 255, 255}; });
    EXPECT_EQ(fillHighlights(white, 235), 0U);
}

TEST(Highlights, AtTheRimAreFilledFromTissueAlone) {
    // A bright spot between tissue at the left and, at the right, what is black or left out.
    for (const int alpha : {0, 255}) {
        Image photo = drawnPhoto(80, 60, [&](int x, int y) -> Channels {
            if (x >= 50) return {0, 0, 0, alpha};
            if (x >= 38 && std::abs(y - 30) < 8) return {255, 255, 255, 255};
            return {150, 60, 50, 255};
        });
        const std::size_t count = countHighlights(photo, 235);
        EXPECT_GE(count, 180U);
        EXPECT_EQ(fillHighlights(photo, 235), count);
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 50; ++x) {
                EXPECT_NEAR(photo.at(x, y)[0], 150, 5) << x << ' ' << y;
                EXPECT_NEAR(photo.at(x, y)[1], 60, 5) << x << ' ' << y;
            }
    }
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

TEST(WhiteBalance, MakesTintedGreyGrey) {
    Image photo = drawnPhoto(64, 64, [](int x, int y) -> Channels {
        const int level = 60 + scattered(x, y, 120);
        return {level, level * 9 / 10, level * 8 / 10, 255};
    });
    const auto gains = findWhiteBalance(photo);
    ASSERT_TRUE(gains);
    multiplyColours(photo, *gains);
    for (int x = 0; x < 64; ++x) {
        const Channels c = colourOf(photo, x, x);
        EXPECT_NEAR(c[0], c[1], 2);
        EXPECT_NEAR(c[2], c[1], 2);
    }
    EXPECT_FALSE(findWhiteBalance(drawnPhoto(9, 9, [](int, int) -> Channels { return {200, 40, 30, 255}; })));
    EXPECT_FALSE(findWhiteBalance({}));
}

TEST(WhiteBalance, GoesByWhatIsNearestToGrey) {
    // A grey drape under a bluish lamp beside pink tissue of the same extent.
    const auto gains = findWhiteBalance(drawnPhoto(64, 64, [](int x, int) -> Channels {
        return x < 32 ? Channels{171, 180, 189, 255} : Channels{200, 130, 130, 255};
    }));
    ASSERT_TRUE(gains);
    EXPECT_NEAR((*gains)[0], 180.0 / 171, 0.02);
    EXPECT_NEAR((*gains)[2], 180.0 / 189, 0.02);
}

TEST(PhotoPreparation, FindsTheLampByWhatHighlightsShow) {
    // Only the soft rims of highlights are nearly grey: to fill highlights must not hide them.
    const Image photo = drawnPhoto(120, 120, [](int x, int y) -> Channels {
        const double distance = std::hypot(x % 30 - 15, y % 30 - 15);
        if (distance < 3) return {255, 255, 255, 255};
        if (distance < 5) return {200, 180, 160, 255};
        return {180, 60, 50, 255};
    });
    PhotoPreparation filled;
    filled.highlightThreshold = 235;
    const PhotoPreparation found = withFound(filled, photo, {false, true});
    ASSERT_TRUE(found.whiteBalance);
    EXPECT_NEAR((*found.whiteBalance)[0], 0.9, 0.01);
    EXPECT_FALSE(withFound(filled, photo, {true, false}).field);
    EXPECT_GT(highlightShare(photo, filled), 0.03);
    EXPECT_EQ(highlightShare(photo, {}), 0);
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

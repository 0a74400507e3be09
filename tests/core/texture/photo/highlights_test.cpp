#include "core/texture/photo/highlights.h"

#include "tests/core/texture/photo/drawn_photo.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace esm;

TEST(Highlights, AreFilledFromTheirSurroundingsAndNothingElseChanges) {
    const Image photo = drawnPhoto(80, 60, [](int x, int y) -> Channels {
        if (std::hypot(x - 40, y - 30) < 5) return {255, 250, 252, 255};
        return {150 + scattered(x, y, 20), 60 + scattered(y, x, 20), 50, 255};
    });
    Image filled = photo;
    const std::size_t count = fillHighlights(filled, highlightMask(photo, usualSensitivity));
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
    EXPECT_EQ(fillHighlights(white, highlightMask(white, usualSensitivity)), 0U);
}

/// As a lens of little correction shows a fleck: white with a lilac rim. A vessel as lilac farther off stays.
TEST(Highlights, LeaveNoLilacOfTheirRims) {
    const Image photo = drawnPhoto(480, 360, [](int x, int y) -> Channels {
        const double away = std::hypot(x - 240, y - 180);
        if (away < 7) return {255, 250, 252, 255};
        if (away < 10) return {190, 120, 175, 255};
        if (std::abs(x - 320) < 3) return {150, 60, 120, 255};
        return {150 + scattered(x, y, 20), 60 + scattered(y, x, 20), 50, 255};
    });
    const PixelMask mask = highlightMask(photo, usualSensitivity);
    Image filled = photo;
    fillHighlights(filled, mask);
    for (int y = 150; y < 210; ++y)
        for (int x = 210; x < 270; ++x)
            EXPECT_LE(filled.at(x, y)[2], 60) << x << ' ' << y;
    for (int y = 0; y < 360; ++y)
        EXPECT_EQ(colourOf(filled, 320, y), colourOf(photo, 320, y)) << y;
}

/// Blue dye, and the green of a fluorescing one, which has no red at all.
TEST(Highlights, KeepTheColoursOfDyedTissue) {
    for (const Channels& dyed : {Channels{90, 80, 170, 255}, Channels{0, 150, 40, 255}}) {
        const Image photo = drawnPhoto(480, 360, [&](int x, int y) -> Channels {
            return std::hypot(x - 240, y - 180) < 7 ? Channels{255, 255, 255, 255} : dyed;
        });
        const PixelMask mask = highlightMask(photo, usualSensitivity);
        EXPECT_LT(std::count(mask.begin(), mask.end(), 255), 700) << "what is dyed is no rim";
        Image filled = photo;
        EXPECT_GT(fillHighlights(filled, mask), 100U);
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(filled.at(240, 180)[channel], dyed[std::size_t(channel)], 6);
    }
}

TEST(Highlights, AtTheRimAreFilledFromTissueAlone) {
    // A bright spot between tissue at the left and, at the right, what is black or left out.
    for (const int alpha : {0, 255}) {
        Image photo = drawnPhoto(80, 60, [&](int x, int y) -> Channels {
            if (x >= 50) return {0, 0, 0, alpha};
            if (x >= 38 && std::abs(y - 30) < 8) return {255, 255, 255, 255};
            return {150, 60, 50, 255};
        });
        const PixelMask mask = highlightsAbove(photo, 235);
        const auto count = static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 255));
        EXPECT_GE(count, 180U);
        EXPECT_EQ(fillHighlights(photo, mask), count);
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 50; ++x) {
                EXPECT_NEAR(photo.at(x, y)[0], 150, 5) << x << ' ' << y;
                EXPECT_NEAR(photo.at(x, y)[1], 60, 5) << x << ' ' << y;
            }
    }
}

TEST(Highlights, AreMoreTheMoreSensitive) {
    // Three spots of ever fainter shine over red tissue, and one bright patch of the tissue's own colour.
    const Image photo = drawnPhoto(200, 80, [](int x, int y) -> Channels {
        const auto within = [&](int at) { return std::hypot(x - at, y - 40) < 5; };
        const int shine = within(30) ? 130 : within(80) ? 60 : within(130) ? 24 : 0;
        if (within(180)) return {180, 90, 75, 255};
        return {120 + shine, 60 + shine, 50 + shine, 255};
    });
    const auto has = [&](double sensitivity, int x) {
        return highlightMask(photo, sensitivity)[static_cast<std::size_t>(40 * 200 + x)] != 0;
    };
    EXPECT_TRUE(has(0.1, 30));
    EXPECT_FALSE(has(0.1, 80));
    EXPECT_TRUE(has(0.5, 80));
    EXPECT_FALSE(has(0.5, 130));
    EXPECT_TRUE(has(1, 130));
    EXPECT_FALSE(has(0.8, 180));
}

TEST(Highlights, AreFoundOnAPalePolypThatStays) {
    const auto isPolyp = [](int x, int y) { return std::hypot(x - 100, y - 100) < 25; };
    const auto fromFleck = [](int x, int y) { return std::hypot(x - 95, y - 105); };
    const Image photo = drawnPhoto(200, 200, [&](int x, int y) -> Channels {
        if (fromFleck(x, y) < 4) return {255, 252, 248, 255};
        return isPolyp(x, y) ? Channels{245, 215, 200, 255} : Channels{220, 105, 80, 255};
    });
    const PixelMask mask = highlightMask(photo, usualSensitivity);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const bool isFilled = mask[static_cast<std::size_t>(y * 200 + x)] != 0;
            EXPECT_TRUE(isFilled ? fromFleck(x, y) < 10 : fromFleck(x, y) >= 4) << x << ' ' << y;
        }
}

TEST(Highlights, AreNotSeenInWhatIsMasked) {
    Image photo = drawnPhoto(80, 80, [](int x, int y) -> Channels {
        const int shine = std::hypot(x - 40, y - 40) < 4 ? 150 : 0;
        return {100 + shine, 40 + shine, 40 + shine, x < 40 ? 0 : 255};
    });
    const PixelMask mask = highlightMask(photo, 1);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 40; ++x)
            EXPECT_EQ(mask[static_cast<std::size_t>(y * 80 + x)], 0);
    EXPECT_EQ(mask[40 * 80 + 41], 255);
}

// Photos wider than 4096 pixels are looked at smaller.
TEST(Highlights, OfVeryLargePhotosAreFoundToo) {
    const Image photo = drawnPhoto(5000, 700, [](int x, int y) -> Channels {
        if (x < 100) return {0, 0, 0, 0};
        if (std::hypot(x - 2500, y - 350) < 30) return {255, 250, 252, 255};
        return {150 + scattered(x, y, 20), 60 + scattered(y, x, 20), 50, 255};
    });
    const PixelMask mask = highlightMask(photo, usualSensitivity);
    ASSERT_EQ(mask.size(), 5000U * 700);
    for (int y = 0; y < 700; ++y)
        for (int x = 0; x < 5000; ++x) {
            const double fromMiddle = std::hypot(x - 2500, y - 350);
            const std::uint8_t value = mask[static_cast<std::size_t>(y) * 5000 + static_cast<std::size_t>(x)];
            ASSERT_TRUE(fromMiddle >= 30 || value == 255) << x << ' ' << y;
            ASSERT_TRUE(fromMiddle <= 60 || value == 0) << x << ' ' << y;
        }
    Image filled = photo;
    EXPECT_GT(fillHighlights(filled, mask), 2800U);
    EXPECT_LT(colourOf(filled, 2500, 350)[2], 90);
}

// Rings hold other highlights, and are highlights of their own.
TEST(Highlights, WithinEachOtherAreEachFilledOnce) {
    const auto isRing = [](int x, int y) {
        const double fromMiddle = std::hypot(x - 60, y - 60);
        return (fromMiddle > 30 && fromMiddle < 36) || fromMiddle < 6;
    };
    Image photo = drawnPhoto(120, 120, [&](int x, int y) -> Channels {
        return isRing(x, y) ? Channels{255, 255, 255, 255} : Channels{150, 60, 50, 255};
    });
    PixelMask mask(120 * 120, 0);
    std::size_t masked = 0;
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x)
            if (isRing(x, y)) {
                mask[static_cast<std::size_t>(y * 120 + x)] = 255;
                ++masked;
            }
    EXPECT_EQ(fillHighlights(photo, mask), masked);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 120; ++x)
            ASSERT_NEAR(colourOf(photo, x, y)[0], 150, 2) << x << ' ' << y;
}

TEST(Highlights, OfPhotosOfAnyShapeAreLookedFor) {
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {2000, 3}, {3, 2000}, {16384, 1}}) {
        const Image photo = drawnPhoto(width, height, [](int, int) -> Channels {
            return {150, 60, 50, 255};
        });
        const PixelMask mask = highlightMask(photo, usualSensitivity);
        EXPECT_EQ(mask.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        EXPECT_EQ(std::count(mask.begin(), mask.end(), 255), 0);
    }
}

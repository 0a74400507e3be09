#include "core/texture/photo/white_balance.h"

#include "tests/core/texture/photo/drawn_photo.h"

#include <gtest/gtest.h>

using namespace esm;

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

TEST(WhiteBalance, GoesByWhatHighlightsAdd) {
    // A bluish lamp over red tissue: light adds up, and what is stored is its root.
    const Image photo = drawnPhoto(240, 240, [](int x, int y) -> Channels {
        const double distance = std::hypot(x % 60 - 30, y % 60 - 30);
        const double shine = distance < 4 ? 0.35 : distance < 6 ? 0.2 : 0;
        const auto stored = [&](double tissue, double lamp) {
            return static_cast<int>(
                std::lround(255 * std::pow(lamp * (std::pow(tissue, 2.2) + shine), 1 / 2.2)));
        };
        return {stored(0.6, 0.7), stored(0.25, 1), stored(0.2, 1.3), 255};
    });
    const auto gains = findWhiteBalance(photo);
    ASSERT_TRUE(gains);
    EXPECT_NEAR((*gains)[0], std::pow(1 / 0.7, 1 / 2.2), 0.02);
    EXPECT_NEAR((*gains)[2], std::pow(1 / 1.3, 1 / 2.2), 0.02);
}

TEST(WhiteBalance, IsUnsureWhereFlecksDisagreeOrNoLampIsAsRed) {
    const auto lamps = [](double redOfSome, double redOfOthers) {
        return findWhiteBalance(drawnPhoto(240, 240, [&](int x, int y) -> Channels {
            const double shine = std::hypot(x % 60 - 30, y % 60 - 30) < 4 ? 0.3 : 0;
            const double red = (x / 60 + y / 60) % 2 == 0 ? redOfSome : redOfOthers;
            const auto stored = [&](double tissue, double lamp) {
                return static_cast<int>(
                    std::lround(255 * std::pow(std::pow(tissue, 2.2) + lamp * shine, 1 / 2.2)));
            };
            return {stored(0.6, red), stored(0.25, 1), stored(0.2, 1), 255};
        }));
    };
    EXPECT_TRUE(lamps(1, 1));
    EXPECT_FALSE(lamps(0.5, 1.4));
    EXPECT_FALSE(lamps(1.4, 1.4));
}

TEST(WhiteBalance, IsUnsureOfPaleMucosa) {
    // Nearly grey under this lamp, and of colours that vary with the blood in it.
    EXPECT_FALSE(findWhiteBalance(drawnPhoto(64, 64, [](int x, int y) -> Channels {
        const int blood = scattered(x / 4, y / 4, 40);
        return {180, 172 - blood, 175 - blood, 255};
    })));
}

TEST(WhiteBalance, IsTakenFromASpotOrFromAnotherPhoto) {
    const auto drape = [](int x, int y, double red, double blue) -> Channels {
        if (x < 32) return {static_cast<int>(150 * red), 150, static_cast<int>(150 * blue), 255};
        const int level = 60 + scattered(x, y, 40);
        return {static_cast<int>(1.6 * level * red), level, static_cast<int>(0.9 * level * blue), 255};
    };
    const Image tinted = drawnPhoto(64, 64, [&](int x, int y) { return drape(x, y, 0.8, 1.2); });
    const Image balanced = drawnPhoto(64, 64, [&](int x, int y) { return drape(x, y, 1, 1); });
    for (const auto& gains : {whiteBalanceOfSpot(tinted, {10, 10}), whiteBalanceLike(tinted, balanced)}) {
        ASSERT_TRUE(gains);
        EXPECT_NEAR((*gains)[0], 1 / 0.8, 0.03);
        EXPECT_NEAR((*gains)[2], 1 / 1.2, 0.03);
    }
    EXPECT_FALSE(whiteBalanceOfSpot(tinted, {-20, 10}));
    EXPECT_FALSE(whiteBalanceLike(tinted, {}));
}

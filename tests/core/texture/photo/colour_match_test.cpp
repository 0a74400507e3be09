#include "core/texture/photo/colour_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace esm;

namespace {

/// Colours that vary around a mean, alike in every picture.
Image speckled(const std::array<double, 3>& mean, double spread, std::uint8_t alpha = 255) {
    Image image{64, 48, {}};
    for (int i = 0; i < 64 * 48; ++i) {
        const double wave = spread * std::sin(0.7 * i) + 0.3 * spread * std::sin(0.13 * i);
        for (const double channel : mean)
            image.pixels.push_back(static_cast<std::uint8_t>(std::lround(channel + wave)));
        image.pixels.push_back(alpha);
    }
    return image;
}

std::array<double, 2> meanAndSpread(const Image& image, std::size_t channel) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = channel; i < image.pixels.size(); i += 4, ++count) {
        sum += image.pixels[i];
        squares += static_cast<double>(image.pixels[i]) * image.pixels[i];
    }
    return {sum / count, std::sqrt(squares / count - sum / count * sum / count)};
}

} // namespace

TEST(ColourMatch, GivesThePhotoMeanAndSpreadOfWhatLiesBeneath) {
    Image photo = speckled({120, 140, 150}, 20);
    const Image beneath = speckled({170, 90, 80}, 30);
    const auto match = matchColours(photo, beneath);
    ASSERT_TRUE(match);
    applyMatch(photo, *match);
    for (const std::size_t channel : {0U, 1U, 2U}) {
        const auto [mean, spread] = meanAndSpread(photo, channel);
        const auto [wantedMean, wantedSpread] = meanAndSpread(beneath, channel);
        EXPECT_NEAR(mean, wantedMean, 4) << channel;
        EXPECT_NEAR(spread, wantedSpread, 4) << channel;
    }
}

TEST(ColourMatch, OfAPictureToItselfChangesNothing) {
    const Image photo = speckled({150, 90, 70}, 25);
    const auto match = matchColours(photo, photo);
    ASSERT_TRUE(match);
    Image matched = photo;
    applyMatch(matched, *match);
    for (std::size_t i = 0; i < photo.pixels.size(); ++i)
        ASSERT_NEAR(matched.pixels[i], photo.pixels[i], 1);
}

TEST(ColourMatch, CountsOnlyWhereBothAreSeen) {
    const Image photo = speckled({120, 140, 150}, 20);
    Image beneath = speckled({170, 90, 80}, 20);
    const auto whole = matchColours(photo, beneath);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 64; ++x)
            std::fill_n(beneath.at(x, y), 4, std::uint8_t{0}); // black, and not seen
    const auto half = matchColours(photo, beneath);
    ASSERT_TRUE(whole && half);
    for (const std::size_t i : {0U, 1U, 2U})
        EXPECT_NEAR(half->offset[i], whole->offset[i], 3);
    EXPECT_FALSE(matchColours(photo, speckled({170, 90, 80}, 20, 0)));
    EXPECT_FALSE(matchColours(photo, {}));
}

TEST(ColourMatch, StaysInItsLimits) {
    const auto match = matchColours(speckled({128, 128, 128}, 3), speckled({128, 128, 128}, 90));
    ASSERT_TRUE(match);
    EXPECT_EQ(match->scale[0], largestSpread);
    const auto flat = matchColours(speckled({128, 128, 128}, 0), speckled({200, 100, 90}, 30));
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->scale, (std::array<double, 3>{1, 1, 1}));
}

/// The camera's noise there lies on both sides of what counts as nearly black.
TEST(ColourMatch, DoesNotSpeckleADarkPhoto) {
    std::mt19937 random(1);
    std::normal_distribution<> noise(0, 4);
    const auto darkPhoto = [&] {
        Image image{400, 300, {}};
        for (int i = 0; i < 400 * 300; ++i) {
            const double level = noise(random);
            for (const double channel : {30, 24, 22})
                image.pixels.push_back(static_cast<std::uint8_t>(std::lround(channel + level)));
            image.pixels.push_back(255);
        }
        return image;
    };
    Image photo = darkPhoto();
    const auto match = matchColours(photo, Image{400, 300, std::vector<std::uint8_t>(4 * 400 * 300, 150)});
    ASSERT_TRUE(match);
    const auto [mean, spread] = meanAndSpread(photo, 0);
    applyMatch(photo, *match);
    const auto [matchedMean, matchedSpread] = meanAndSpread(photo, 0);
    EXPECT_GT(matchedMean, 2 * mean);
    EXPECT_LT(matchedSpread / matchedMean, spread / mean) << "the noise is not stretched";
}

TEST(ColourMatch, NeitherCountsNorTintsBlackCorners) {
    const auto withCorner = [](Image image) {
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 30; ++x)
                std::fill_n(image.at(x, y), 3, std::uint8_t{12});
        return image;
    };
    const Image beneath = speckled({170, 90, 80}, 20);
    Image photo = withCorner(speckled({120, 140, 150}, 20));
    const auto match = matchColours(photo, beneath);
    ASSERT_TRUE(match);
    applyMatch(photo, *match);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 30; ++x)
            EXPECT_EQ(photo.at(x, y)[0], 12);
    double sum = 0;
    for (int y = 20; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            sum += photo.at(x, y)[0];
    EXPECT_NEAR(sum / (28 * 64), 170, 6);
}

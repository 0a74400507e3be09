#include "core/texture/finish/finish_picture.h"
#include "tests/core/texture/layers/painted_pages.h"

using namespace esm;
using namespace esm::test;

namespace {

constexpr int finishedSize = 200;

/// Red tissue with what is laid on it.
std::shared_ptr<const Photo> tissueWith(const std::function<std::optional<Colour>(int x, int y)>& laid) {
    return makePhoto(finishedSize, finishedSize, [&](int x, int y) {
        return laid(x, y).value_or(Colour{150, 60, 50, 255});
    });
}

bool isWithin(int x, int y, int centre, int radius) {
    return std::hypot(x - centre, y - centre) < radius;
}

Image pictureOfFinish(const Photo& photo, const LayerFinish& finish,
                      const PhotoPreparation& preparation = {}) {
    const Image shown = prepared(photo.image, preparation);
    const FilmAndHeights found{
        std::make_shared<const std::vector<std::uint8_t>>(filmOf(photo.image, preparation)),
        std::make_shared<const std::vector<std::int8_t>>(heightsOf(shown))};
    return finishPicture(shown, found, finish, std::max(finish.relief, 0.001));
}

LayerFinish dryWith(double wetAtHighlights, double relief) {
    LayerFinish finish;
    finish.surface = {0.5, 0.2};
    finish.wetAtHighlights = wetAtHighlights;
    finish.relief = relief;
    return finish;
}

} // namespace

TEST(FinishPicture, IsWetterWhereThePhotoHasAHighlight) {
    const auto photo = tissueWith([](int x, int y) -> std::optional<Colour> {
        if (isWithin(x, y, 60, 3)) return Colour{255, 250, 250, 255};
        return std::nullopt;
    });
    const Image wet = pictureOfFinish(*photo, dryWith(1, 0)), dry = pictureOfFinish(*photo, dryWith(0, 0));
    EXPECT_GT(wet.at(60, 60)[0], 200);
    EXPECT_LT(wet.at(60, 60)[1], 0.5 * dry.at(60, 60)[1]); // and smoother
    EXPECT_EQ(pixelAt(wet, 150, 150), pixelAt(dry, 150, 150));
    EXPECT_EQ(pixelAt(dry, 60, 60), (Colour{51, 128, 128, 255}));
}

TEST(FinishPicture, TakesWhatFilledHighlightsShowForNoRelief) {
    const auto photo = tissueWith([](int x, int y) -> std::optional<Colour> {
        if (isWithin(x, y, 60, 3)) return Colour{255, 250, 250, 255};
        return std::nullopt;
    });
    PhotoPreparation filled;
    filled.highlightSensitivity = 0.5;
    EXPECT_GT(pictureOfFinish(*photo, dryWith(0, 0.001)).at(60, 60)[2], 200);
    EXPECT_NEAR(pictureOfFinish(*photo, dryWith(0, 0.001), filled).at(60, 60)[2], 128, 3);
}

TEST(FinishPicture, TakesBrightForHighAndDarkForLow) {
    const auto photo = tissueWith([](int x, int y) -> std::optional<Colour> {
        if (isWithin(x, y, 60, 2)) return Colour{180, 72, 60, 255};
        if (isWithin(x, y, 140, 2)) return Colour{120, 48, 40, 255};
        return std::nullopt;
    });
    const Image picture = pictureOfFinish(*photo, dryWith(0, 0.001));
    EXPECT_GT(picture.at(60, 60)[2], 128 + 10);
    EXPECT_LT(picture.at(140, 140)[2], 128 - 10);
    EXPECT_EQ(picture.at(100, 100)[2], 128);
}

/// The same noise on tissue and in the dark, where it would be large beside the light.
TEST(FinishPicture, TakesNoNoiseOfTheDarkForRelief) {
    const auto heightsOver = [](int light) {
        const auto photo = makePhoto(finishedSize, finishedSize, [&](int x, int y) {
            const auto grey = std::uint8_t(light + (7 * x + 11 * y) % 6);
            return Colour{grey, grey, grey, 255};
        });
        const Image picture = pictureOfFinish(*photo, dryWith(0, 0.001));
        int most = 0;
        for (int y = 50; y < 150; ++y)
            for (int x = 50; x < 150; ++x)
                most = std::max(most, std::abs(picture.at(x, y)[2] - 128));
        return most;
    };
    EXPECT_EQ(heightsOver(4), 0);
    EXPECT_LE(heightsOver(20), 6);
    EXPECT_GE(heightsOver(60), 2) << "what is as bright as tissue keeps its detail";
}

/// Detail as wide in relation, of a photo beyond the size at which it is looked at.
TEST(FinishPicture, IsTheSameOfAVeryLargePhoto) {
    const auto striped = [](int size) {
        return makePhoto(size, 40, [&](int x, int) {
            const auto grey = std::uint8_t(120 + 30 * std::sin(2 * M_PI * 100 * (x + 0.5) / size));
            return Colour{grey, grey, grey, 255};
        });
    };
    const Image large = pictureOfFinish(*striped(8192), dryWith(0, 0.001));
    const Image small = pictureOfFinish(*striped(4096), dryWith(0, 0.001));
    ASSERT_EQ(large.width, 8192);
    for (int x = 100; x < 4000; x += 7)
        EXPECT_NEAR(large.at(2 * x, 20)[2], small.at(x, 20)[2], 4) << x;
}

TEST(FinishPicture, TakesNoStepToWhatIsTransparentForRelief) {
    const auto photo = tissueWith([](int x, int) -> std::optional<Colour> {
        if (x < 100) return Colour{0, 0, 0, 0};
        return std::nullopt;
    });
    const Image picture = pictureOfFinish(*photo, dryWith(0, 0.001));
    for (int x = 0; x < finishedSize; ++x) {
        EXPECT_EQ(picture.at(x, 50)[2], 128) << x;
        EXPECT_EQ(picture.at(x, 50)[3], x < 100 ? 0 : 255) << x;
    }
}

TEST(FinishPicture, KnowsAPhotoOfOneColourForOneWithoutDetail) {
    EXPECT_FALSE(hasDetail(tissueWith([](int, int) { return std::nullopt; })->image));
    EXPECT_TRUE(hasDetail(tissueWith([](int x, int y) -> std::optional<Colour> {
                              if ((x + y) % 7 < 3) return Colour{165, 66, 55, 255};
                              return std::nullopt;
                          })->image));
}

#include "core/texture/photo/colour_adjustment.h"

#include "core/support/angles.h"
#include "tests/core/texture/photo/drawn_photo.h"
#include "tests/support/colour_difference.h"

#include <gmock/gmock.h>

#include <cmath>

using namespace esm;

namespace {

/// Every grey from black to white, in a row.
Image greyWedge() {
    return drawnPhoto(256, 1, [](int x, int) -> Channels { return {x, x, x, 255}; });
}

/// Tissue, fat, bile and a blue instrument, none near the end of what sRGB can show.
Image tissueColours() {
    return drawnPhoto(4, 1, [](int x, int) -> Channels {
        constexpr std::array<Channels, 4> colours{
            {{168, 92, 84, 255}, {196, 170, 120, 255}, {110, 130, 84, 255}, {100, 116, 150, 255}}};
        return colours[static_cast<std::size_t>(x)];
    });
}

double chromaOf(const LabColour& lab) {
    return std::hypot(lab[1], lab[2]);
}

} // namespace

TEST(ColourAdjustment, ThatIsNeutralChangesNoBit) {
    const Image photo = drawnPhoto(40, 30, [](int x, int y) -> Channels {
        return {scattered(x, y, 255), scattered(y, x, 255), scattered(x + y, y, 255), 255};
    });
    Image same = photo;
    adjustColours(same, {});
    EXPECT_EQ(same.pixels, photo.pixels);
}

TEST(ColourAdjustment, LevelsTakeTheirPointsToBlackAndWhiteAndBendByGamma) {
    Image wedge = greyWedge();
    adjustColours(wedge, {50, 200, 2, 1, 1, 0});
    for (int value = 0; value < 256; ++value) {
        const double share = std::min(std::max((value - 50) / 150.0, 0.0), 1.0);
        EXPECT_NEAR(wedge.at(value, 0)[0], 255 * std::sqrt(share), 0.51) << value;
    }
    EXPECT_EQ(wedge.at(50, 0)[0], 0);
    EXPECT_EQ(wedge.at(200, 0)[0], 255);
}

TEST(ColourAdjustment, ContrastStretchesAboutMiddleGrey) {
    Image more = greyWedge(), none = greyWedge();
    adjustColours(more, {0, 255, 1, 1.5, 1, 0});
    adjustColours(none, {0, 255, 1, 0, 1, 0});
    for (int value = 0; value < 256; ++value) {
        EXPECT_NEAR(more.at(value, 0)[1], std::min(std::max(127.5 + 1.5 * (value - 127.5), 0.0), 255.0),
                    0.51);
        EXPECT_EQ(none.at(value, 0)[2], 128);
    }
}

TEST(ColourAdjustment, TurnsHueAndKeepsLightnessAndChroma) {
    for (const double turn : {-40.0, 15.0, 60.0}) {
        const Image before = tissueColours();
        Image after = before;
        adjustColours(after, {0, 255, 1, 1, 1, turn});
        for (int x = 0; x < before.width; ++x) {
            const auto lab = labOf(before.at(x, 0)), turned = labOf(after.at(x, 0));
            EXPECT_NEAR(turned[0], lab[0], 0.5);
            EXPECT_NEAR(chromaOf(turned), chromaOf(lab), 0.8);
            const double angle = std::atan2(turned[2], turned[1]) - std::atan2(lab[2], lab[1]);
            EXPECT_NEAR(std::remainder(toDegrees(angle) - turn, 360), 0, 2.5);
        }
    }
}

TEST(ColourAdjustment, SaturationScalesChromaDownToGrey) {
    const Image before = tissueColours();
    Image half = before, grey = before;
    adjustColours(half, {0, 255, 1, 1, 0.5, 0});
    adjustColours(grey, {0, 255, 1, 1, 0, 0});
    for (int x = 0; x < before.width; ++x) {
        const auto lab = labOf(before.at(x, 0));
        EXPECT_NEAR(chromaOf(labOf(half.at(x, 0))), chromaOf(lab) / 2, 0.8);
        EXPECT_NEAR(labOf(half.at(x, 0))[0], lab[0], 0.5);
        const Channels colour = colourOf(grey, x, 0);
        EXPECT_EQ(colour, (Channels{colour[0], colour[0], colour[0], 255}));
        EXPECT_NEAR(labOf(grey.at(x, 0))[0], lab[0], 0.5);
    }
}

TEST(ColourAdjustment, LeavesWhatIsMasked) {
    Image photo = drawnPhoto(2, 1, [](int x, int) -> Channels { return {160, 80, 70, 255 * x}; });
    adjustColours(photo, {30, 220, 1.3, 1.4, 0.5, 90});
    EXPECT_EQ(colourOf(photo, 0, 0), (Channels{160, 80, 70, 0}));
    EXPECT_NE(colourOf(photo, 1, 0), (Channels{160, 80, 70, 255}));
}

TEST(ColourAdjustment, NamesWhatIsWrong) {
    EXPECT_THAT(validate(ColourAdjustment{}), testing::IsEmpty());
    EXPECT_THAT(validate(ColourAdjustment{99.5, 100, 1, 1, 1, 0}),
                testing::ElementsAre(testing::HasSubstr("above the black point")));
    EXPECT_THAT(validate(ColourAdjustment{0, 255, 0, 1, 1, std::nan("")}),
                testing::ElementsAre(testing::HasSubstr("gamma must be from 0.1 to 10"),
                                     testing::HasSubstr("hue must be from -180 to 180 degrees")));
}

#include "core/exchange/simulators/inventor_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace esm {
namespace {

TEST(InventorText, NamesAreIdentifiers) {
    EXPECT_EQ(inventorName("liver_2"), "liver_2");
    EXPECT_EQ(inventorName("left lobe/2"), "left_lobe_2");
    EXPECT_EQ(inventorName("2 lobes"), "_2_lobes");
    EXPECT_EQ(inventorName(""), "_");
    EXPECT_EQ(inventorName("Nähe"), "N__he") << "a letter of two bytes";
}

TEST(InventorText, StringsKeepWhatInventorCanSay) {
    EXPECT_EQ(inventorString("Leber \"rechts\" / äöü {x}"), "\"Leber \\\"rechts\\\" / äöü {x}\"");
    EXPECT_EQ(inventorString("a\\\nb\x7F"), "\"a/ b \"");
}

TEST(InventorText, NumbersAreTheShortestThatGiveTheSameFloat) {
    EXPECT_EQ(inventorNumber(0.1), "0.1");
    EXPECT_EQ(inventorNumber(0), "0");
    EXPECT_EQ(inventorNumber(-2.5), "-2.5");
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> bits(0, 0x7F7FFFFF);
    for (int i = 0; i < 10000; ++i) {
        const float value = std::bit_cast<float>(bits(random));
        EXPECT_EQ(std::strtof(inventorNumber(static_cast<double>(value)).c_str(), nullptr), value);
    }
}

TEST(InventorText, PixelsAreNumbersWithRedFirst) {
    const Image image{2, 2, {1, 2, 3, 255, 255, 0, 16, 0, 9, 9, 9, 255, 0, 0, 0, 255}};
    EXPECT_EQ(inventorPixels(image, 0), "0x010203 0xff0010 ");
    EXPECT_EQ(inventorPixels(image, 1), "0x090909 0x000000 ");
}

} // namespace
} // namespace esm

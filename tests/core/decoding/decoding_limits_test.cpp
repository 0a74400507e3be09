#include "core/decoding/decoding_limits.h"

#include <gtest/gtest.h>

namespace esm {
namespace {

TEST(DecodingLimits, AllowSmallFilesAndGrowUpToALimit) {
    const DecodingLimits small = meshDecodingLimits(1000), large = meshDecodingLimits(100'000'000);
    EXPECT_GE(small.memory, 1'000'000'000U);
    EXPECT_GE(small.seconds, 60U);
    EXPECT_GE(large.memory, small.memory);
    EXPECT_GT(large.seconds, small.seconds);
    EXPECT_LE(largestMeshDecodingLimits().memory, 8'000'000'000U);
    EXPECT_EQ(meshDecodingLimits(~std::uint64_t{0}).memory, largestMeshDecodingLimits().memory);
    EXPECT_LE(2 * mostMeshFileBytes(), largestMeshDecodingLimits().memory);
}

TEST(DecodingLimits, LetAPicturesPixelsBack) {
    const DecodingLimits limits = pictureDecodingLimits(268'000'000, 500'000'000);
    EXPECT_GE(limits.output, 4U * 268'000'000 + 12);
    EXPECT_GE(limits.memory, 1'000'000'000U);
}

TEST(DecodingLimits, SurviveAsArguments) {
    const DecodingLimits limits{1, ~std::uint64_t{0}, 3};
    const std::vector<std::string> words = asArguments(limits);
    ASSERT_EQ(words.size(), std::size_t{limitArguments});
    const char* const arguments[] = {words[0].c_str(), words[1].c_str(), words[2].c_str()};
    const DecodingLimits back = limitsFromArguments(arguments);
    EXPECT_EQ(back.memory, limits.memory);
    EXPECT_EQ(back.output, limits.output);
    EXPECT_EQ(back.seconds, limits.seconds);
    const char* const words2[] = {"1", "many", "3"};
    EXPECT_THROW(limitsFromArguments(words2), std::invalid_argument);
}

} // namespace
} // namespace esm

#include "core/support/text_lines.h"

#include <gmock/gmock.h>

#include <cmath>

namespace esm {
namespace {

using testing::ElementsAre;

std::vector<std::string> linesOf(const std::string& text) {
    const Bytes content(text.begin(), text.end());
    TextLines lines(content);
    std::vector<std::string> all;
    for (std::string_view line; lines.next(line);) {
        all.emplace_back(line);
        EXPECT_EQ(lines.number(), all.size());
    }
    return all;
}

TEST(TextLines, EndAsOnAnySystem) {
    EXPECT_THAT(linesOf("a b\n\nc"), ElementsAre("a b", "", "c"));
    EXPECT_THAT(linesOf("a\r\nb\r\n"), ElementsAre("a", "b"));
    EXPECT_THAT(linesOf(std::string("a\0\0", 3)), ElementsAre("a"));
    EXPECT_THAT(linesOf(""), ElementsAre());
}

TEST(TakeWord, TakesOneAfterTheOther) {
    std::string_view line = "  v\t1.5  2 ";
    EXPECT_EQ(takeWord(line), "v");
    EXPECT_EQ(takeWord(line), "1.5");
    EXPECT_EQ(takeWord(line), "2");
    EXPECT_EQ(takeWord(line), "");
    EXPECT_EQ(takeWord(line), "");
}

TEST(WholeNumber, IsTheWholeWordOrNone) {
    EXPECT_EQ(wholeNumber<double>("+1.5e-3"), 1.5e-3);
    EXPECT_EQ(wholeNumber<double>("1e400"), INFINITY);
    EXPECT_EQ(wholeNumber<double>("1e-400"), 0);
    EXPECT_TRUE(std::isnan(wholeNumber<double>("nan").value()));
    EXPECT_EQ(wholeNumber<std::uint32_t>("4294967295"), 4294967295U);
    for (const char* word : {"4294967296", "-1", "1.5", "1x", "", "+", "x"})
        EXPECT_EQ(wholeNumber<std::uint32_t>(word), std::nullopt) << word;
}

} // namespace
} // namespace esm

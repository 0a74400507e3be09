#include "core/c/failure.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

TEST(Failure, SaysNothingWhereNothingFailed) {
    EsmError error;
    report(&error, "an older one");
    EXPECT_EQ(guarded(&error, 0, [] { return 7; }), 7);
    EXPECT_STREQ(error.text, "");
}

TEST(Failure, NoExceptionLeaves) {
    EsmError error;
    EXPECT_EQ(guarded(&error, -1, []() -> int { throw InvalidModel("no such node"); }), -1);
    EXPECT_STREQ(error.text, "no such node");
    EXPECT_EQ(guarded(&error, -1, []() -> int { throw 7; }), -1);
    EXPECT_STRNE(error.text, "");
    EXPECT_EQ(guarded(nullptr, -1, []() -> int { throw InvalidModel("nobody asked"); }), -1);
}

TEST(Failure, ALongTextEndsWithAWholeCharacter) {
    EsmError error;
    for (std::size_t odd = 0; odd < 3; ++odd) {
        std::string text(odd, 'x');
        while (text.size() < 2 * sizeof error.text)
            text += "ü";
        report(&error, text);
        const std::string shown = error.text;
        EXPECT_GT(shown.size(), sizeof error.text - 6);
        EXPECT_EQ((shown.size() - odd - 3) % 2, 0U) << "half a letter before the ellipsis";
        EXPECT_THAT(shown, testing::EndsWith("…"));
    }
    const std::string fits(sizeof error.text - 1, 'x');
    report(&error, fits);
    EXPECT_EQ(error.text, fits);
}

} // namespace
} // namespace esm

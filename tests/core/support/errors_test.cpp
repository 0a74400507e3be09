#include "core/support/errors.h"

#include <gtest/gtest.h>

#include <new>

using namespace esm;

TEST(InvalidModel, NamesTheFirstProblemsAndCountsTheRest) {
    EXPECT_STREQ(InvalidModel(std::vector<std::string>{"a", "b"}).what(), "a; b");
    const InvalidModel many(std::vector<std::string>(1000, "x"));
    EXPECT_EQ(many.problems().size(), 1000U);
    const std::string text = many.what(), end = "; and 980 more";
    EXPECT_EQ(text.size(), 20 * 3 - 2 + end.size());
    EXPECT_EQ(text.substr(text.size() - end.size()), end);
}

TEST(ReasonOf, IsInTheUsersWords) {
    EXPECT_EQ(reasonOf(FileError("organ.esm", "is empty")), "organ.esm: is empty");
    EXPECT_EQ(reasonOf(std::bad_alloc()), "there is not enough memory for it");
    EXPECT_EQ(reasonOf(std::bad_array_new_length()), "there is not enough memory for it");
}

#include "core/support/joined.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Joined, SeparatesWhatThereIs) {
    EXPECT_EQ(joined({}), "");
    EXPECT_EQ(joined({"a"}), "a");
    EXPECT_EQ(joined({"", "b", "c"}), ", b, c");
    EXPECT_EQ(joined({"mm", "cm"}, "|"), "mm|cm");
}

TEST(Joined, TakesTheNamesOfThings) {
    struct Thing {
        std::string name;
    };
    EXPECT_EQ(joinedNames(std::vector<Thing>{{"left"}, {"right"}}), "left, right");
}

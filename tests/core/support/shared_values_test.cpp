#include "core/support/shared_values.h"

#include <gtest/gtest.h>

#include <string>

using namespace esm;

TEST(SharedValues, AreComparedByWhatTheyAre) {
    const ByValue<std::string> liver = std::make_shared<const std::string>("liver");
    const ByValue<std::string> again = std::make_shared<const std::string>("liver");
    const ByValue<std::string> colon = std::make_shared<const std::string>("colon");
    const ByValue<std::string> none;
    EXPECT_TRUE(liver == again);
    EXPECT_FALSE(liver == colon);
    EXPECT_FALSE(liver == none);
    EXPECT_FALSE(none == liver);
    EXPECT_TRUE(none == ByValue<std::string>());
}

TEST(SharedValues, MakeNoDifferenceWhereTheyAreDerived) {
    const Derived<std::string> made = std::make_shared<const std::string>("liver");
    EXPECT_TRUE(made == Derived<std::string>());
}

TEST(SharedValues, CompareWithPlainPointersAndNone) {
    const ByValue<std::string> liver = std::make_shared<const std::string>("liver");
    EXPECT_EQ(liver, std::make_shared<const std::string>("liver"));
    EXPECT_NE(liver, std::make_shared<const std::string>("colon"));
    EXPECT_NE(liver, nullptr);
    EXPECT_EQ(ByValue<std::string>(), nullptr);
    EXPECT_EQ(Derived<std::string>(), nullptr);
}

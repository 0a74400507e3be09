#include "core/support/numbers.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(Numbers, ArePositiveOnlyWhenFinite) {
    EXPECT_TRUE(isPositive(5e-324));
    EXPECT_TRUE(isPositive(1e308));
    for (const double value : {0.0, -1.0, double{NAN}, double{INFINITY}})
        EXPECT_FALSE(isPositive(value)) << value;
}

TEST(Numbers, OfTissueAreBounded) {
    EXPECT_TRUE(isAmount(0) && isAmount(1e30));
    EXPECT_TRUE(isMass(1e-30) && isMass(1e30));
    for (const double value : {-1e-300, 1.1e30, double{NAN}, double{INFINITY}})
        EXPECT_FALSE(isAmount(value) || isMass(value)) << value;
    EXPECT_FALSE(isMass(0));
}

TEST(ExactText, ReadsBackTheSame) {
    EXPECT_EQ(exactText(0.5), "0.5");
    EXPECT_EQ(exactText(-3), "-3");
    EXPECT_EQ(exactText(0.1 + 0.2), "0.30000000000000004");
    EXPECT_EQ(exactText(1e-5), "1.0e-05");
    EXPECT_EQ(exactText(1.5e30), "1.5e+30");
}

TEST(NumberText, HasSoManyDigitsAtMost) {
    EXPECT_EQ(roundedText(0.5), "0.5");
    EXPECT_EQ(roundedText(1.0 / 3), "0.333333");
    EXPECT_EQ(roundedText(1.0 / 3, 2), "0.33");
    EXPECT_EQ(roundedText(1e30), "1e+30");
}

TEST(TimeInText, TakesTheUnitThatItsDigitsFit) {
    EXPECT_EQ(timeInText(2.5912e-6), "2.59 µs");
    EXPECT_EQ(timeInText(0.00099949), "999 µs");
    EXPECT_EQ(timeInText(0.00099951), "1 ms");
    EXPECT_EQ(timeInText(0.05), "50 ms");
    EXPECT_EQ(timeInText(0.9996), "1 s");
    EXPECT_EQ(timeInText(1.5), "1.5 s");
    EXPECT_EQ(timeInText(4321), "4321 s");
}

TEST(PercentText, IsForPeople) {
    EXPECT_EQ(percentText(0.0123), "1.2 %");
    EXPECT_EQ(percentText(0.5), "50 %");
    EXPECT_EQ(percentText(0.9996), "100 %");
    EXPECT_EQ(percentText(3.345), "335 %");
    EXPECT_EQ(percentText(2e-9), "2e-07 %");
}

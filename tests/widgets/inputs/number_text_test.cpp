#include "widgets/inputs/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace esm;

namespace {

struct Reading {
    const char* text;
    double number;
    const char* unit;
};

} // namespace

TEST(NumberText, ReadsBackWhatItWrites) {
    for (const double value : {0.0, 5.5, -0.4, 16.2606, 81309.1, 2.4567e-7, -1.5e9}) {
        const auto read = readNumber(numberText(value) + " N/m");
        ASSERT_TRUE(read) << value;
        EXPECT_NEAR(read->number, value, 5e-4 * std::abs(value)) << value;
        EXPECT_EQ(read->unit, "N/m");
    }
}

TEST(NumberText, WritesAtLeastFourDigits) {
    EXPECT_EQ(numberText(16.2606), "16.26");
    EXPECT_EQ(numberText(123456789), "123456789");
    EXPECT_EQ(numberText(2e9), "2.000e+09");
    EXPECT_EQ(numberText(-0.4), QString(QChar(0x2212)) + "0.4000");
    EXPECT_EQ(numberText(2.4e-7), QString("2.400e") + QChar(0x2212) + "07");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), QString(QChar(0x2013)));
}

TEST(NumberText, UnderstandsWhatPeopleType) {
    for (const Reading& reading :
         {Reading{" 2,5 mm", 2.5, "mm"}, Reading{"1e-3", 1e-3, ""}, Reading{"5cm", 5, "cm"},
          Reading{"1 234", 1234, ""}, Reading{"1 234 567,5 µm", 1234567.5, "µm"}, Reading{"+.5 %", 0.5, "%"},
          Reading{"12 34", 12, "34"}, Reading{"7.", 7, ""}}) {
        const auto read = readNumber(QString::fromUtf8(reading.text));
        ASSERT_TRUE(read) << reading.text;
        EXPECT_EQ(read->number, reading.number) << reading.text;
        EXPECT_EQ(read->unit, QString::fromUtf8(reading.unit)) << reading.text;
    }
    EXPECT_EQ(readNumber(countText(21940))->number, 21940);
    EXPECT_EQ(readNumber(numberText(-3))->number, -3);
}

TEST(NumberText, RefusesWhatIsNoNumber) {
    for (const char* text : {"", "abc", "-", "N/m", "1e999"})
        EXPECT_FALSE(readNumber(text)) << text;
}

TEST(NumberText, NeverWritesAMinusBeforeZero) {
    EXPECT_EQ(decimalText(-0.01, 1), "0.0");
}

TEST(NumberText, SaysOneUnitInAnother) {
    EXPECT_DOUBLE_EQ(unitRatio("cm", "mm").value(), 10);
    EXPECT_DOUBLE_EQ(unitRatio("g", "kg").value(), 1e-3);
    EXPECT_DOUBLE_EQ(unitRatio("N/mm", "N/m").value(), 1000);
    EXPECT_DOUBLE_EQ(unitRatio("mN", "N").value(), 1e-3);
    EXPECT_DOUBLE_EQ(unitRatio("mmHg", "Pa").value(), 133.322387415);
    EXPECT_NEAR(unitRatio("cmH2O", "mmHg").value(), 0.7356, 1e-4);
    EXPECT_EQ(unitRatio("px", "px"), 1.0);
    EXPECT_FALSE(unitRatio("kg", "mm"));
    EXPECT_FALSE(unitRatio("234", "mm"));
}

TEST(WithUnit, LeavesNoGapWithoutOne) {
    EXPECT_EQ(withUnit(16.26, "N/m"), "16.26 N/m");
    EXPECT_EQ(withUnit(16.26, "N/m", 3), "16.3 N/m");
    EXPECT_EQ(withUnit(2, {}), "2.000");
}

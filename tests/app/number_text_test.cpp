#include "widgets/inputs/number_field.h"
#include "widgets/inputs/number_text.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

#include <limits>

using namespace esm;

TEST(NumberText, ReadsBackWhatItWrites) {
    for (const double value : {0.0, 5.5, -0.4, 16.2606, 81309.1, 2.4e-7, -1.5e9}) {
        const auto read = parseNumber(numberText(value) + " N/m");
        ASSERT_TRUE(read) << value;
        EXPECT_NEAR(*read, value, 2e-2 * std::abs(value)) << value;
    }
}

TEST(NumberText, UnderstandsCommaAndSpaces) {
    EXPECT_EQ(parseNumber(" 2,5 mm"), 2.5);
    EXPECT_EQ(parseNumber(countText(21940)), 21940);
    EXPECT_EQ(parseNumber("1e-3"), 1e-3);
}

TEST(NumberText, RefusesWhatIsNoNumber) {
    for (const char* text : {"", "abc", "-", "N/m", "1e999"})
        EXPECT_FALSE(parseNumber(text)) << text;
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), QString(QChar(0x2013)));
}

TEST(NumberText, NeverWritesAMinusBeforeZero) {
    EXPECT_EQ(decimalText(-0.01, 1), "0.0");
}

namespace {

NumberFormat millimetres() {
    NumberFormat format;
    format.unit = "mm";
    format.shownPerValue = 1000;
    format.decimals = 1;
    format.minimum = 0;
    format.maximum = 1;
    return format;
}

} // namespace

TEST(NumberField, TakesWhatIsTypedInTheShownUnit) {
    NumberField field(millimetres());
    field.setValue(0.01);
    EXPECT_EQ(field.text(), "10.0 mm");
    QSignalSpy edited(&field, &NumberField::valueEdited);
    field.selectAll();
    QTest::keyClicks(&field, "25");
    QTest::keyClick(&field, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_DOUBLE_EQ(field.value().value(), 0.025);
    EXPECT_EQ(field.text(), "25.0 mm");
}

TEST(NumberField, KeepsItsValueWhenTheTextIsNoneOrOutOfRange) {
    NumberField field(millimetres());
    field.setValue(0.01);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    for (const char* text : {"-3", "abc", "5000", ""}) {
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        EXPECT_EQ(field.text(), "10.0 mm") << text;
    }
    EXPECT_EQ(edited.count(), 0);
}

TEST(NumberField, IsNotRoundedByLookingAtIt) {
    NumberField field(millimetres());
    field.setValue(0.0123456);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 0);
    EXPECT_EQ(field.value(), 0.0123456);
}

#include "widgets/fuzzy/term_scale.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

class TermScaleTest : public testing::Test {
protected:
    void SetUp() override {
        FuzzyVariable variable;
        variable.maximum = 10;
        variable.terms = {{"very_small", {0, 0, 2, 4}}, {"large", {6, 8, 10, 10}}};
        scale.setVariable(variable);
        scale.resize(300, scale.sizeHint().height());
        scale.show();
    }
    QImage painted() { return scale.grab().toImage(); }

    TermScale scale;
    QSignalSpy picked{&scale, &TermScale::termPicked};
};

} // namespace

TEST_F(TermScaleTest, AClickPicksTheMiddleOfATermsCore) {
    for (const int tenth : {1, 9, 5})
        QTest::mouseClick(&scale, Qt::LeftButton, {}, {scale.width() * tenth / 10, scale.height() / 2});
    ASSERT_EQ(picked.count(), 2) << "between the terms lies none";
    EXPECT_EQ(picked[0][0].toDouble(), 1);
    EXPECT_EQ(picked[1][0].toDouble(), 9);
}

TEST_F(TermScaleTest, TheRangeBeginsWhereTheSlidersHandleStands) {
    scale.setInset(50);
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {50 + 20, scale.height() / 2});
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {50 + 180, scale.height() / 2});
    ASSERT_EQ(picked.count(), 2);
    EXPECT_EQ(picked[0][0].toDouble(), 1);
    EXPECT_EQ(picked[1][0].toDouble(), 9);
}

TEST_F(TermScaleTest, CrowdedTermsTakeASecondRowAndStayAtTheirPlaces) {
    const int oneRow = scale.sizeHint().height();
    FuzzyVariable crowded;
    crowded.maximum = 10;
    crowded.terms = {{"rather_soft", {3, 4, 4, 5}}, {"medium", {4, 5, 5, 6}}, {"rather_firm", {5, 6, 6, 7}}};
    scale.setVariable(crowded);
    EXPECT_GT(scale.sizeHint().height(), oneRow);
    scale.resize(300, scale.sizeHint().height());
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {150, scale.height() - 4});
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked[0][0].toDouble(), 5) << "the middle one stands in the lower row";
}

TEST_F(TermScaleTest, TheTermsOfTheValueStandOut) {
    const QImage none = painted();
    scale.setValue(9);
    const QImage large = painted();
    EXPECT_NE(none, large);
    EXPECT_EQ(none.copy(0, 0, 100, 40), large.copy(0, 0, 100, 40));
    scale.setValue(5);
    EXPECT_EQ(painted(), none) << "5 belongs to neither";
}

TEST_F(TermScaleTest, ANoteTakesThePlaceOfTheTerms) {
    const QImage terms = painted();
    scale.setNote("no rule reaches it");
    EXPECT_NE(painted(), terms);
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {30, scale.height() / 2});
    EXPECT_EQ(picked.count(), 0);
    scale.setNote({});
    EXPECT_EQ(painted(), terms);
}

TEST(ReadableName, HasSpacesForUnderscores) {
    EXPECT_EQ(readableName("very_small"), "very small");
}

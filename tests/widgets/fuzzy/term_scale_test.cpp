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
    }
    QImage painted() { return scale.grab().toImage(); }

    TermScale scale;
    QSignalSpy picked{&scale, &TermScale::termPicked};
};

} // namespace

TEST_F(TermScaleTest, AClickPicksTheMiddleOfATermsCore) {
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {4, scale.height() / 2});
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {scale.width() - 4, scale.height() / 2});
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {scale.width() / 2, scale.height() / 2});
    ASSERT_EQ(picked.count(), 2) << "between the terms lies none";
    EXPECT_EQ(picked[0][0].toDouble(), 1);
    EXPECT_EQ(picked[1][0].toDouble(), 9);
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
    QTest::mouseClick(&scale, Qt::LeftButton, {}, {4, scale.height() / 2});
    EXPECT_EQ(picked.count(), 0);
    scale.setNote({});
    EXPECT_EQ(painted(), terms);
}

TEST(ReadableName, HasSpacesForUnderscores) {
    EXPECT_EQ(readableName("very_small"), "very small");
}

#include "tests/support/eventually.h"
#include "widgets/fuzzy/linguistic_slider.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

FuzzyVariable firmness() {
    FuzzyVariable variable;
    variable.name = "firmness";
    variable.minimum = -10;
    variable.maximum = 90;
    variable.terms = {{"very_soft", {-10, -10, -4, 20}}, {"firm", {20, 60, 90, 90}}};
    return variable;
}

/// No number below zero, though the variable's range begins there.
NumberFormat aboveZero() {
    NumberFormat format;
    format.unit = "N/m";
    format.minimum = 0;
    return format;
}

class LinguisticSliderTest : public testing::Test {
protected:
    LinguisticSlider row{firmness(), "firmness", aboveZero()};
    QSignalSpy edited{&row, &LinguisticSlider::valueEdited};
    QSignalSpy finished{&row, &LinguisticSlider::editingFinished};
};

} // namespace

TEST_F(LinguisticSliderTest, ShowsAValueWithoutAnnouncingIt) {
    row.setValue(40);
    EXPECT_EQ(row.slider()->value(), (row.slider()->minimum() + row.slider()->maximum()) / 2);
    EXPECT_EQ(row.field()->text(), "40.00 N/m");
    row.setValue(std::nullopt);
    EXPECT_EQ(row.field()->text(), QString(QChar(0x2013)));
    EXPECT_EQ(edited.count() + finished.count(), 0);
}

TEST_F(LinguisticSliderTest, SliderAndNumberFollowEachOther) {
    row.slider()->setValue(row.slider()->maximum());
    ASSERT_EQ(edited.count(), 1);
    EXPECT_DOUBLE_EQ(edited[0][0].toDouble(), 90);
    EXPECT_EQ(row.field()->value(), 90.0);
    row.field()->selectAll();
    QTest::keyClicks(row.field(), "40");
    QTest::keyClick(row.field(), Qt::Key_Return);
    EXPECT_EQ(row.slider()->value(), row.slider()->maximum() / 2);
    EXPECT_EQ(finished.count(), 1) << "what is typed is an edit of its own";
}

TEST_F(LinguisticSliderTest, NothingBeyondTheLimitsIsAnnounced) {
    row.setValue(40);
    row.slider()->setValue(row.slider()->minimum());
    EXPECT_EQ(edited.back()[0].toDouble(), 0);
    row.field()->selectAll();
    QTest::keyClicks(row.field(), "-5");
    QTest::keyClick(row.field(), Qt::Key_Return);
    EXPECT_FALSE(row.field()->refusal().isEmpty());
    EXPECT_EQ(edited.count(), 1);
    auto* terms = row.findChild<TermScale*>();
    terms->resize(300, terms->sizeHint().height());
    QTest::mouseClick(terms, Qt::LeftButton, {}, {21, terms->height() - 5}); // "very soft", −7
    EXPECT_EQ(row.field()->value(), 0.0);
}

TEST_F(LinguisticSliderTest, AWordStandsWhereTheHandleGoesForIt) {
    row.resize(300, row.sizeHint().height());
    row.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&row, patience));
    auto* terms = row.findChild<TermScale*>();
    const double firm = 0.85 * row.slider()->maximum(); // the middle of its core, 75 of −10 to 90
    const int half = row.slider()->handleWidth() / 2;
    const int x = half + qRound(0.85 * (row.slider()->width() - 2 * half));
    QTest::mouseClick(terms, Qt::LeftButton, {}, {x, terms->height() - 5});
    EXPECT_NEAR(row.slider()->value(), firm, 1);
    row.setValue(0);
    QTest::mouseClick(row.slider(), Qt::LeftButton, {}, {x, row.slider()->height() / 2});
    EXPECT_NEAR(row.field()->value().value_or(0), 75, 0.5);
}

TEST_F(LinguisticSliderTest, AWordIsAnEditOfItsOwn) {
    row.setValue(40);
    QTest::keyClick(row.field(), Qt::Key_Up);
    ASSERT_EQ(finished.count(), 0);
    int finishedAtWord = -1;
    QObject::connect(&row, &LinguisticSlider::valueEdited, &row, [&] { finishedAtWord = finished.count(); });
    auto* terms = row.findChild<TermScale*>();
    terms->resize(300, terms->sizeHint().height());
    QTest::mouseClick(terms, Qt::LeftButton, {}, {21, terms->height() - 5});
    EXPECT_EQ(finishedAtWord, 1);
    EXPECT_EQ(finished.count(), 2);
}

TEST_F(LinguisticSliderTest, KeysOnTheSliderEndAsAnEdit) {
    QTest::keyClick(row.slider(), Qt::Key_Right);
    EXPECT_EQ(finished.count(), 0);
    EXPECT_TRUE(finished.wait(5000));
}

#include "tests/support/eventually.h"
#include "widgets/inputs/value_slider.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

using namespace esm;

namespace {

class ValueSliderTest : public testing::Test {
protected:
    void SetUp() override {
        auto* column = new QVBoxLayout(&window);
        column->addWidget(slider);
        column->addWidget(other);
        slider->setRange(0, 100);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
        QApplication::setActiveWindow(&window);
    }
    void turnWheel() {
        QWheelEvent event({5, 5}, slider->mapToGlobal(QPoint(5, 5)), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider, &event);
    }

    QWidget window;
    ValueSlider* slider = new ValueSlider(&window);
    ValueSlider* other = new ValueSlider(&window);
    QSignalSpy finished{slider, &ValueSlider::gestureFinished};
};

} // namespace

TEST_F(ValueSliderTest, TheWheelMovesItOnlyWithTheFocus) {
    other->setFocus();
    turnWheel();
    EXPECT_EQ(slider->value(), 0);
    EXPECT_FALSE(slider->hasFocus());
    slider->setFocus();
    turnWheel();
    EXPECT_GT(slider->value(), 0);
}

TEST_F(ValueSliderTest, KeysAndWheelEndTheirGestureAfterAPause) {
    slider->setFocus();
    slider->setPause(std::chrono::hours(1));
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    EXPECT_EQ(finished.count(), 0);
    slider->setPause(std::chrono::milliseconds(0));
    EXPECT_TRUE(finished.wait(5000));
    turnWheel();
    EXPECT_TRUE(finished.wait(5000));
    EXPECT_EQ(finished.count(), 2);
}

TEST_F(ValueSliderTest, APressEndsWhatTheKeysBegan) {
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    int finishedAtPress = -1;
    QObject::connect(slider, &QSlider::valueChanged, &window, [&] { finishedAtPress = finished.count(); });
    QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
    EXPECT_EQ(finishedAtPress, 1);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
    EXPECT_EQ(finished.count(), 2);
}

TEST_F(ValueSliderTest, LeavingItEndsTheGesture) {
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    other->setFocus();
    EXPECT_EQ(finished.count(), 1);
}

TEST_F(ValueSliderTest, APressOnTheTrackBringsTheHandleThereAndItFollows) {
    slider->resize(214, slider->height());
    const int half = slider->handleWidth() / 2, length = slider->width() - slider->handleWidth();
    const int y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, {half + length * 3 / 4, y});
    EXPECT_NEAR(slider->value(), 75, 1);
    QMouseEvent move(QEvent::MouseMove, QPoint(half + length / 4, y), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(slider, &move);
    EXPECT_NEAR(slider->value(), 25, 1);
    EXPECT_EQ(finished.count(), 0);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, {half + length / 4, y});
    EXPECT_EQ(finished.count(), 1) << "all of it is one edit";
}

TEST_F(ValueSliderTest, TheHandleStaysUnderTheMouseThatTookIt) {
    slider->resize(214, slider->height());
    slider->setValue(50);
    const QPoint off(slider->width() / 2 + 3, slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, off);
    EXPECT_EQ(slider->value(), 50);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, off);
}

TEST_F(ValueSliderTest, LettingGoOfTheHandleEndsTheGesture) {
    slider->setSliderDown(true);
    slider->setValue(30);
    EXPECT_EQ(finished.count(), 0);
    slider->setSliderDown(false);
    EXPECT_EQ(finished.count(), 1);
}

#include "tests/support/eventually.h"
#include "widgets/inputs/control_keys.h"

#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

using namespace esm;

namespace {

/// A window with shortcuts on keys that controls answer as well.
class ControlKeysTest : public testing::Test {
protected:
    void SetUp() override {
        auto* column = new QVBoxLayout(&window);
        for (QWidget* control : std::initializer_list<QWidget*>{button, choice, slider, plain})
            column->addWidget(control);
        choice->addItems({"a", "b", "c"});
        plain->setFocusPolicy(Qt::StrongFocus);
        play.setShortcut(Qt::Key_Space);
        home.setShortcut(Qt::Key_Home);
        window.addActions({&play, &home});
        keepControlKeys(window);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
        QApplication::setActiveWindow(&window);
    }
    void press(QWidget* control, Qt::Key key) {
        control->setFocus();
        QTest::keyClick(control, key);
    }

    QWidget window;
    QPushButton* button = new QPushButton(&window);
    QComboBox* choice = new QComboBox(&window);
    QSlider* slider = new QSlider(Qt::Horizontal, &window);
    QWidget* plain = new QWidget(&window);
    QAction play, home;
    QSignalSpy played{&play, &QAction::triggered}, wentHome{&home, &QAction::triggered};
};

} // namespace

TEST_F(ControlKeysTest, SpacePressesAButtonAndElsewhereIsTheWindows) {
    QSignalSpy clicked(button, &QPushButton::clicked);
    press(button, Qt::Key_Space);
    EXPECT_EQ(clicked.count(), 1);
    EXPECT_EQ(played.count(), 0);
    press(slider, Qt::Key_Space);
    press(plain, Qt::Key_Space);
    EXPECT_EQ(played.count(), 2);
}

TEST_F(ControlKeysTest, HomeMovesASlider) {
    slider->setValue(50);
    press(slider, Qt::Key_Home);
    EXPECT_EQ(slider->value(), 0);
    EXPECT_EQ(wentHome.count(), 0);
    press(plain, Qt::Key_Home);
    EXPECT_EQ(wentHome.count(), 1);
}

TEST_F(ControlKeysTest, TheWheelTurnsAChoiceOnlyWithTheFocus) {
    guardFromWheel(*choice);
    plain->setFocus();
    const auto turn = [this] {
        QWheelEvent event({5, 5}, choice->mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(choice, &event);
    };
    turn();
    EXPECT_EQ(choice->currentIndex(), 0);
    choice->setFocus();
    turn();
    EXPECT_EQ(choice->currentIndex(), 1);
}

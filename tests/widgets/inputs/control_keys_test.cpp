#include "tests/support/eventually.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/number_field.h"

#include <gtest/gtest.h>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabBar>
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

namespace {

/// A window whose keys belong to `plain` where no control needs them.
class KeysHomeTest : public ControlKeysTest {
protected:
    void SetUp() override {
        ControlKeysTest::SetUp();
        window.layout()->addWidget(number);
        window.layout()->addWidget(name);
        window.layout()->addWidget(tabs);
        tabs->addTab("one");
        tabs->addTab("another");
        tabs->setFocusPolicy(Qt::StrongFocus);
        QApplication::processEvents();
        giveKeysHome(window, *plain);
    }
    void typeAndEnter(QLineEdit* field, const QString& text) {
        field->setFocus();
        field->setText({});
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void openList() {
        choice->setFocus();
        choice->showPopup();
        ESM_EVENTUALLY(choice->view()->isVisible());
    }

    NumberField* number = new NumberField(NumberFormat{.unit = "mm", .maximum = 10}, &window);
    QLineEdit* name = new QLineEdit(&window);
    QTabBar* tabs = new QTabBar(&window);
};

} // namespace

TEST_F(KeysHomeTest, EnterTakesWhatWasTypedAndGivesTheKeysBack) {
    typeAndEnter(number, "5 mm");
    EXPECT_EQ(number->value(), 5);
    EXPECT_TRUE(plain->hasFocus());
    typeAndEnter(name, "left lobe");
    EXPECT_TRUE(plain->hasFocus());
}

TEST_F(KeysHomeTest, AButtonOrTabThatTheMousePressedGivesThemBack) {
    QSignalSpy clicked(button, &QPushButton::clicked);
    QTest::mouseClick(button, Qt::LeftButton, {}, {3, 3});
    EXPECT_EQ(clicked.count(), 1);
    ESM_EVENTUALLY(plain->hasFocus());
    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
    EXPECT_EQ(tabs->currentIndex(), 1);
    EXPECT_TRUE(tabs->hasFocus());
    ESM_EVENTUALLY(plain->hasFocus());
    press(button, Qt::Key_Space); // by the keyboard it is pressed again and again
    EXPECT_EQ(clicked.count(), 2);
    QApplication::processEvents();
    EXPECT_TRUE(button->hasFocus());
}

TEST_F(KeysHomeTest, WhatIsRefusedKeepsTheKeysToBeMended) {
    typeAndEnter(number, "11 mm");
    EXPECT_TRUE(number->hasFocus());
}

TEST_F(KeysHomeTest, AChoiceGivesTheKeysBackHoweverItsListCloses) {
    openList();
    QTest::keyClick(choice->view(), Qt::Key_Down);
    QTest::keyClick(choice->view(), Qt::Key_Return);
    // Without a window manager nobody gives the window the keys again.
    ESM_EVENTUALLY(window.focusWidget() == plain);
    EXPECT_EQ(choice->currentText(), "b");
    QApplication::setActiveWindow(&window);
    QTest::keyClick(plain, Qt::Key_Home);
    EXPECT_EQ(choice->currentText(), "b");
    EXPECT_EQ(wentHome.count(), 1);

    openList();
    QTest::keyClick(choice->view(), Qt::Key_Escape);
    ESM_EVENTUALLY(window.focusWidget() == plain);
    EXPECT_EQ(choice->currentText(), "b");
}

TEST_F(KeysHomeTest, ArrowKeysGoThroughAChoiceWithoutLeavingIt) {
    press(choice, Qt::Key_Down);
    press(choice, Qt::Key_Down);
    EXPECT_EQ(choice->currentText(), "c");
    QTest::qWait(0);
    EXPECT_TRUE(choice->hasFocus());
}

TEST_F(KeysHomeTest, AWindowThatComesToTheFrontWithoutAnyoneAtTheKeysGivesThemHome) {
    number->setFocus();
    number->clearFocus();
    ASSERT_EQ(window.focusWidget(), nullptr);
    QEvent activate(QEvent::WindowActivate);
    QApplication::sendEvent(&window, &activate);
    EXPECT_TRUE(plain->hasFocus());
}

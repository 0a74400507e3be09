#include "app/editor/dialogs/screen_room.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>
#include <QDialog>
#include <QScreen>
#include <QTest>

using namespace esm;

namespace {

QRect screenOf(const QWidget& window) {
    return window.screen()->availableGeometry();
}

} // namespace

TEST(ScreenRoom, ADialogThatIsTooLargeFitsItsScreenOnceItIsShown) {
    QWidget main;
    main.show();
    QDialog dialog(&main);
    dialog.setMinimumSize(screenOf(main).size() + QSize(100, 100));
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, patience));
    EXPECT_EQ(dialog.size().boundedTo(roomOnScreen(dialog)), dialog.size());
}

TEST(ScreenRoom, AWindowThatReachesOverTheEdgeIsMovedBack) {
    QWidget main;
    main.show();
    QWidget beside(&main, Qt::Tool);
    beside.resize(300, 200);
    beside.move(screenOf(main).bottomRight() - QPoint(60, 40));
    beside.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&beside, patience));
    ESM_EVENTUALLY(screenOf(beside).contains(beside.geometry()));
    EXPECT_EQ(beside.size(), QSize(300, 200));
}

TEST(ScreenRoom, AWindowThatHasRoomKeepsItsSize) {
    QWidget main;
    main.show();
    QDialog dialog(&main);
    dialog.resize(320, 240);
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, patience));
    EXPECT_EQ(dialog.size(), QSize(320, 240));
}

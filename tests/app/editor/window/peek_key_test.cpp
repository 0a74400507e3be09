#include "app/editor/window/peek_key.h"

#include <gtest/gtest.h>
#include <QTest>
#include <QWidget>

using namespace esm;

namespace {

class PeekKeyTest : public testing::Test {
protected:
    PeekKeyTest() {
        window.addAction(&action);
        action.setShortcut(Qt::Key_B);
        action.setCheckable(true);
        new PeekKey(action, [this] { return now; });
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        QApplication::setActiveWindow(&window);
    }
    void hold(qint64 milliseconds) {
        QTest::keyPress(&window, Qt::Key_B);
        EXPECT_TRUE(action.isChecked() != wasChecked) << "at once";
        now += milliseconds;
        QTest::keyRelease(&window, Qt::Key_B);
    }

    QWidget window;
    QAction action{&window};
    qint64 now = 0;
    bool wasChecked = false;
};

} // namespace

TEST_F(PeekKeyTest, ATapSwitches) {
    hold(80);
    EXPECT_TRUE(action.isChecked());
    wasChecked = true;
    hold(80);
    EXPECT_FALSE(action.isChecked());
}

TEST_F(PeekKeyTest, WhoHoldsTheKeyOnlyHasALook) {
    hold(1500);
    EXPECT_FALSE(action.isChecked());
    action.trigger();
    EXPECT_TRUE(action.isChecked()) << "from a menu it switches";
    wasChecked = true;
    hold(1500);
    EXPECT_TRUE(action.isChecked());
}

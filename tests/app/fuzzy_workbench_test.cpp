#include "app/editor/panels/fuzzy_workbench.h"

#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QPushButton>
#include <QStackedWidget>
#include <QTabBar>

using namespace esm;

namespace {

class FuzzyWorkbenchTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        press(Qt::Key_R, Qt::ControlModifier);
    }
    QWidget* ownWindow() const { return child<QWidget>("workbenchWindow"); }
    bool isInColumn() const { return window->findChild<FuzzyWorkbench*>()->isAncestorOf(tabs()); }
    QTabBar* tabs() const { return child<QTabBar>("workbenchTabs"); }
};

} // namespace

TEST_F(FuzzyWorkbenchTest, MovesIntoAWindowOfItsOwnAndBack) {
    EXPECT_TRUE(isInColumn());
    press(Qt::Key_F8);
    ASSERT_TRUE(ownWindow());
    EXPECT_TRUE(ownWindow()->isVisible());
    EXPECT_FALSE(isInColumn());
    EXPECT_TRUE(ownWindow()->windowTitle().contains("susilap-g"));
    ownWindow()->resize(700, 500);
    ownWindow()->close();
    EXPECT_FALSE(ownWindow()->isVisible());
    EXPECT_TRUE(isInColumn());
    EXPECT_FALSE(window->windowActions().fuzzyWindow->isChecked());
    press(Qt::Key_F8);
    EXPECT_EQ(ownWindow()->size(), QSize(700, 500));
}

TEST_F(FuzzyWorkbenchTest, LeavesTheMainWindowsKeysInForce) {
    window->document().edit("mass", [](Project& p) { p.base.mass *= 2; });
    const int edits = window->document().undoStack()->index();
    press(Qt::Key_F8);
    ASSERT_TRUE(QTest::qWaitForWindowActive(ownWindow()));
    tabs()->setFocus();
    QTest::keyClick(tabs(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->document().undoStack()->index(), edits - 1);
}

TEST_F(FuzzyWorkbenchTest, GoesWithTheMainWindow) {
    press(Qt::Key_F8);
    window.reset();
    for (const QWidget* left : QApplication::topLevelWidgets())
        EXPECT_NE(left->objectName(), "workbenchWindow");
}

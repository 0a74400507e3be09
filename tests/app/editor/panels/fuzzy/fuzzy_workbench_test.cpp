#include "app/editor/panels/fuzzy/fuzzy_workbench.h"

#include "app/editor/window/file_controller.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"
#include "widgets/fuzzy/corner_fields.h"

#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>

using namespace esm;

namespace {

class FuzzyWorkbenchTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        addPublishedRegion();
        meanEveryRegion();
    }
    QWidget* ownWindow() const { return child<QWidget>("workbenchWindow"); }
    bool isInColumn() const { return window->findChild<FuzzyWorkbench*>()->isAncestorOf(tabs()); }
    QTabBar* tabs() const { return child<QTabBar>("workbenchTabs"); }
    /// Types a corner of the first term in the window of its own, and leaves the cursor in it.
    void typeACorner(const QString& text) {
        press(Qt::Key_F8);
        chooseTab("Domains");
        child<QListWidget>("termList")->setCurrentRow(0);
        corner = child<CornerFields>("corners")->field(Corner::D);
        QApplication::setActiveWindow(ownWindow());
        corner->setFocus();
        corner->selectAll();
        QTest::keyClicks(corner, text);
        ASSERT_TRUE(corner->isModified());
    }
    static double end(const Project& project) {
        return project.regions.back().system->inputs[0].terms[0].set.d;
    }

    NumberField* corner = nullptr;
};

} // namespace

TEST_F(FuzzyWorkbenchTest, MovesIntoAWindowOfItsOwnAndBack) {
    EXPECT_TRUE(isInColumn());
    press(Qt::Key_F8);
    ASSERT_TRUE(ownWindow());
    EXPECT_TRUE(ownWindow()->isVisible());
    EXPECT_FALSE(isInColumn());
    EXPECT_TRUE(ownWindow()->windowTitle().contains("susilap-g"));
    ownWindow()->resize(800, 600);
    ownWindow()->close();
    EXPECT_FALSE(ownWindow()->isVisible());
    EXPECT_TRUE(isInColumn());
    EXPECT_FALSE(window->windowActions().fuzzyWindow->isChecked());
    press(Qt::Key_F8);
    EXPECT_EQ(ownWindow()->size(), QSize(800, 600));
}

TEST_F(FuzzyWorkbenchTest, SaysWhatToDoWithoutASystem) {
    const auto* empty = child<QLabel>("noSystem");
    const int height = settledHeight(window->findChild<FuzzyWorkbench*>());
    EXPECT_FALSE(empty->isVisible());
    window->findChild<Selection*>()->setRegion(std::nullopt);
    EXPECT_TRUE(empty->isVisible());
    EXPECT_FALSE(tabs()->isVisible());
    window->findChild<Selection*>()->setRegion(project().regions.back().id);
    EXPECT_FALSE(empty->isVisible());
    EXPECT_TRUE(tabs()->isVisible());
    EXPECT_EQ(settledHeight(window->findChild<FuzzyWorkbench*>()), height);
}

TEST_F(FuzzyWorkbenchTest, TheKeyThatClosesMeansTheActiveWindow) {
    press(Qt::Key_F8);
    QApplication::setActiveWindow(ownWindow());
    ESM_EVENTUALLY(QApplication::activeWindow() == ownWindow());
    window->windowActions().close->trigger();
    EXPECT_FALSE(ownWindow()->isVisible());
    EXPECT_TRUE(window->view().isVisible()) << "the organ stays";
}

TEST_F(FuzzyWorkbenchTest, AnotherTabTakesTheKeysFromTheOneBefore) {
    chooseTab("Rules");
    auto* rules = child<QWidget>("ruleText");
    rules->setFocus();
    ASSERT_EQ(window->focusWidget(), rules);
    chooseTab("Domains");
    const QWidget* focus = window->focusWidget();
    EXPECT_TRUE(!focus || !focus->hasFocus() || focus == &window->view())
        << focus->objectName().toStdString();
}

TEST_F(FuzzyWorkbenchTest, TheRulesNeedNoMoreRoomThanTheyTake) {
    window->resize(1440, 868);
    chooseTab("Domains");
    chooseTab("Rules");
    auto* workbench = window->findChild<FuzzyWorkbench*>();
    auto* column = qobject_cast<QScrollArea*>(workbench->parentWidget()->parentWidget()->parentWidget());
    ASSERT_TRUE(column);
    column->parentWidget()->raise();
    settledHeight(workbench);
    EXPECT_EQ(column->verticalScrollBar()->maximum(), 0) << "the tabs behind may be taller";
}

TEST_F(FuzzyWorkbenchTest, LeavesTheMainWindowsKeysInForce) {
    window->document().edit("mass", [](Project& p) { p.base.mass *= 2; });
    const int edits = window->document().undoStack()->index();
    press(Qt::Key_F8);
    ASSERT_TRUE(QTest::qWaitForWindowActive(ownWindow(), patience));
    tabs()->setFocus();
    QTest::keyClick(tabs(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->document().undoStack()->index(), edits - 1);
}

TEST_F(FuzzyWorkbenchTest, WhatIsTypedInItIsSaved) {
    const TemporaryFolder folder;
    ASSERT_TRUE(window->files().saveTo(folder / "tube.esm"));
    typeACorner("3.4");
    QTest::keyClick(corner, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(end(loadProject(folder / "tube.esm")), 3.4);
    EXPECT_FALSE(window->document().isModified());
    ESM_EVENTUALLY(corner->hasFocus());
}

TEST_F(FuzzyWorkbenchTest, WhatIsTypedInItIsNotLostWithTheMainWindowUnasked) {
    window->document().markSaved("/nowhere/tube.esm", project());
    typeACorner("3.4");
    dialogs.expectButton("unsavedBox", QMessageBox::Cancel);
    QTest::keyClick(corner, Qt::Key_Q, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(window->isVisible());
    EXPECT_EQ(end(project()), 3.4);
}

TEST_F(FuzzyWorkbenchTest, GoesWithTheMainWindow) {
    press(Qt::Key_F8);
    window.reset();
    for (const QWidget* left : QApplication::topLevelWidgets())
        EXPECT_NE(left->objectName(), "workbenchWindow");
}

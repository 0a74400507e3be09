#include "app/editor/window/start_page.h"

#include "app/editor/document/journal.h"
#include "app/editor/window/export_controller.h"
#include "app/editor/window/file_controller.h"
#include "app/editor/workers/preview.h"
#include "core/exchange/project/project_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QToolBar>

using namespace esm;

namespace {

class StartTest : public EditorTest {
protected:
    /// What a test that was killed left behind would be offered.
    void SetUp() override { std::filesystem::remove_all(recoveryFolder()); }
    void start(const std::vector<std::filesystem::path>& files = {}) {
        open(makeSample("liver"));
        window->start(files);
    }
    StartPage* page() const { return window->findChild<StartPage*>("startPage"); }
    QString notice() const {
        for (auto* label : window->view().findChildren<QLabel*>("viewNoticeText"))
            if (label->isVisible()) return label->text();
        return {};
    }
    QPushButton* entryNamed(const QString& name) const {
        for (auto* button : page()->findChildren<QPushButton*>())
            if (button->accessibleName() == name) return button;
        return nullptr;
    }
};

} // namespace

TEST_F(StartTest, NoOrganIsForcedOnTheUser) {
    start();
    EXPECT_TRUE(page()->isVisible());
    EXPECT_FALSE(window->view().isVisible());
    for (QDockWidget* column : window->findChildren<QDockWidget*>())
        EXPECT_FALSE(column->isVisible());
    ESM_EVENTUALLY(!window->preview().status().playing);
    const Project before = project();
    for (const int key : {Qt::Key_S, Qt::Key_O, Qt::Key_V, Qt::Key_P})
        press(key);
    press(Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(project() == before) << "there is nothing to edit";
    EXPECT_FALSE(window->preview().status().playing);
}

TEST_F(StartTest, ClosingAnOrganComesBackToThePage) {
    start();
    EXPECT_FALSE(window->windowActions().close->isEnabled() && window->windowActions().close->isVisible());
    window->windowActions().samples.front().second->trigger();
    press(Qt::Key_F8);
    window->document().edit("mass", [](Project& project) { project.base.mass *= 2; });
    dialogs.expectButton("unsavedBox", QMessageBox::Cancel);
    press(Qt::Key_W, Qt::ControlModifier);
    EXPECT_TRUE(window->view().isVisible());
    dialogs.expectButton("unsavedBox", QMessageBox::Discard);
    press(Qt::Key_W, Qt::ControlModifier);
    EXPECT_TRUE(page()->isVisible());
    EXPECT_FALSE(window->document().isModified()) << "nothing is left to lose";
    EXPECT_FALSE(child<QWidget>("workbenchWindow")->isVisible());
    ESM_EVENTUALLY(!window->preview().status().playing);
    window->windowActions().samples.front().second->trigger();
    EXPECT_TRUE(window->view().isVisible());
}

TEST_F(StartTest, ASampleTakesThePlaceOfThePage) {
    start();
    window->windowActions().samples.front().second->trigger();
    EXPECT_FALSE(page()->isVisible());
    EXPECT_TRUE(window->view().isVisible());
    EXPECT_TRUE(window->windowActions().addRegion->isVisible());
    EXPECT_TRUE(window->findChild<QToolBar*>("topBar")->isVisible());
    ESM_EVENTUALLY(window->preview().status().playing);
}

TEST_F(StartTest, WhatWasOpenedLastIsOpenedByOneClick) {
    TemporaryFolder folder;
    const auto file = folder / "kidney.esm";
    saveProject(makeSample("tube"), file);
    start({file});
    ESM_EVENTUALLY(window->document().path());
    EXPECT_FALSE(page()->isVisible());
    window.reset();
    start();
    QPushButton* entry = entryNamed("kidney.esm");
    ASSERT_NE(entry, nullptr);
    entry->click();
    EXPECT_EQ(window->document().path(), file);
    EXPECT_FALSE(page()->isVisible());
}

TEST_F(StartTest, AFileThatCannotBeOpenedLeavesThePage) {
    TemporaryFolder folder;
    dialogs.expect([](QWidget* dialog) { return qobject_cast<QMessageBox*>(dialog) != nullptr; },
                   [](QDialog* dialog) { dialog->reject(); });
    start({folder / "none.esm"});
    ESM_EVENTUALLY(dialogs.isDone());
    EXPECT_TRUE(page()->isVisible());
}

TEST_F(StartTest, FirstStepsGoOnAsTheyAreDone) {
    start();
    entryNamed("First steps")->click();
    EXPECT_FALSE(page()->isVisible());
    EXPECT_TRUE(notice().startsWith("1 of 5")) << notice().toStdString();
    ESM_EVENTUALLY(window->preview().status().playing);
    window->preview().setPull(Pull{0, project().network->restPositions[0]});
    ESM_EVENTUALLY(notice().startsWith("2 of 5"));
    window->preview().setPull(std::nullopt);
    window->windowActions().addRegion->trigger();
    ESM_EVENTUALLY(notice().startsWith("3 of 5"));
    const std::string slider = project().regions.back().system->inputs.front().name;
    EXPECT_TRUE(notice().contains("“" + QString::fromStdString(slider) + "”")) << notice().toStdString();
    EXPECT_NE(window->findChild<QWidget*>(QString::fromStdString("input-" + slider)), nullptr);
    window->document().edit("inputs", [](Project& p) { p.regions.back().inputs.front().second += 0.5; });
    ESM_EVENTUALLY(notice().startsWith("4 of 5"));
    const auto pull = [&] {
        window->preview().setPull(Pull{0, project().network->restPositions[0]});
        window->preview().setPull(std::nullopt);
    };
    pull();
    EXPECT_TRUE(notice().startsWith("4 of 5")) << "only the region was pulled at";
    pull();
    EXPECT_TRUE(notice().startsWith("5 of 5"));
    TemporaryFolder folder;
    window->files().exports().exportTo(folder / "liver.glb");
    ESM_EVENTUALLY(!notice().startsWith("5 of 5"));
    EXPECT_TRUE(notice().startsWith("Exported liver")) << notice().toStdString();
}

TEST_F(StartTest, AHintCanBePassedOver) {
    start();
    entryNamed("First steps")->click();
    ASSERT_TRUE(notice().startsWith("1 of 5"));
    for (auto* next : window->view().findChildren<QPushButton*>("viewNoticeHelp"))
        if (next->isVisible() && next->text() == "Next") next->click();
    EXPECT_TRUE(notice().startsWith("2 of 5")) << notice().toStdString();
}

TEST_F(StartTest, AnotherOrganEndsTheFirstSteps) {
    start();
    entryNamed("First steps")->click();
    ASSERT_TRUE(notice().startsWith("1 of 5"));
    window->files().openSample("tube");
    EXPECT_EQ(notice(), "");
}

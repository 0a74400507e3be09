#include "app/editor/panels/tissue/tissue_preset_button.h"
#include "app/editor/window/file_controller.h"
#include "core/authoring/accuracy.h"
#include "core/exchange/image_file.h"
#include "core/samples/samples.h"
#include "tests/app/access_complaints.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QAction>
#include <QMenu>

#include <fstream>

using namespace esm;

namespace {

/// Everything that takes keys or clicks has a name, a value and a tool tip; what each test shows is looked
/// at.
class AccessTest : public EditorTest {
protected:
    static void expectNone(QWidget& shown) {
        for (const QString& complaint : accessComplaints(shown))
            ADD_FAILURE() << complaint.toStdString();
    }
    void openWithRegionAndPhoto() {
        open(makeSample("liver"));
        writePng(makeSamplePhoto(samplePhotoNames().front())->image, folder / "photo.png");
        window->files().openAny(folder / "photo.png");
        ASSERT_EQ(project().layers.size(), 1U);
        window->windowActions().tissue->trigger();
        window->windowActions().addRegion->trigger();
        ASSERT_FALSE(project().regions.empty());
    }
    void chooseEveryTab(const char* name = "workbenchTabs") {
        auto* tabs = child<QTabBar>(name);
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            expectNone(*tabs->window());
        }
    }
    void takeEveryTool() {
        for (QAction* tool : window->windowActions().tools->actions()) {
            if (!tool->isEnabled()) continue;
            tool->trigger();
            expectNone(*window);
        }
    }
    void expectOfWindow(const char* name) {
        auto* shown = child<QWidget>(name);
        ASSERT_NE(shown, nullptr) << name;
        EXPECT_TRUE(shown->isVisible()) << name;
        expectNone(*shown);
    }
    void lookAtNextDialog(const char* name) {
        dialogs.expectNamed(name, [](QDialog* dialog) {
            expectNone(*dialog);
            dialog->reject();
        });
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(AccessTest, TheWorkspaceTissueCanBeHeardAndExplainsItself) {
    openWithRegionAndPhoto();
    takeEveryTool();
    chooseEveryTab();
    window->windowActions().cut->trigger();
    expectNone(*window);
}

TEST_F(AccessTest, TheWorkspaceTextureCanBeHeardAndExplainsItself) {
    openWithRegionAndPhoto();
    window->windowActions().texture->trigger();
    takeEveryTool();
    window->windowActions().addPaint->trigger();
    takeEveryTool();
}

TEST_F(AccessTest, TheWorkspaceMeasureCanBeHeardAndExplainsItself) {
    open(makeSample("tube"));
    window->windowActions().measure->trigger();
    expectNone(*window);
    Tradeoff measured;
    measured.reference.stepping = {Integrator::Rk4, 1e-5, Precision::Double};
    measured.runs = {{{Integrator::Split2, 0.01, Precision::Double}, 170, true, 0.02, false, 0.1, {}}};
    window->document().edit("measure", [&](Project& edited) {
        edited.accuracy = std::make_shared<const MeasuredAccuracy>(
            measuredAccuracy(measuredOrgan(edited), detailOf(*edited.network), measured));
    });
    expectNone(*window);
    chooseEveryTab("measurePages");
}

TEST_F(AccessTest, WithNothingSelectedControlsSayWhyTheyCannotBeUsed) {
    open(makeSample("uterus"));
    expectNone(*window);
    window->windowActions().texture->trigger();
    expectNone(*window);
}

TEST_F(AccessTest, TheStartPageCanBeHeard) {
    open(makeSample("liver"));
    window->start({});
    expectNone(*window);
}

TEST_F(AccessTest, WindowsBesideTheOrganCanBeHeard) {
    openWithRegionAndPhoto();
    window->windowActions().history->trigger();
    expectOfWindow("historyWindow");
    window->windowActions().fuzzyWindow->trigger();
    chooseEveryTab();
    window->windowActions().fuzzyWindow->trigger();
    window->windowActions().texture->trigger();
    child<QAbstractButton>("largePhoto")->click();
    expectOfWindow("photoDialog");
    for (auto* tool : child<QDialog>("photoDialog")->findChildren<QAbstractButton*>())
        if (tool->isCheckable() && tool->isVisible()) {
            tool->click();
            expectOfWindow("photoDialog");
        }
}

TEST_F(AccessTest, QuestionsCanBeHeard) {
    openWithRegionAndPhoto();
    lookAtNextDialog("keysDialog");
    window->windowActions().keys->trigger();
    EXPECT_TRUE(dialogs.isDone());

    std::ofstream(folder / "box.obj") << "v 0 0 0\nv 90 0 0\nv 0 90 0\nv 0 0 90\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    lookAtNextDialog("importDialog");
    window->files().openAny(folder / "box.obj");
    EXPECT_TRUE(dialogs.isDone());

    auto* presets = window->findChild<TissuePresetButton*>()->menu();
    emit presets->aboutToShow();
    lookAtNextDialog("presetBox");
    presets->findChild<QAction*>("tube")->trigger();
    EXPECT_TRUE(dialogs.isDone());

    lookAtNextDialog("insideDialog");
    window->windowActions().chooseInside->trigger();
    EXPECT_TRUE(dialogs.isDone());
}

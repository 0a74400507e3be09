#include "app/editor/window/export_controller.h"

#include "app/editor/window/file_controller.h"
#include "core/samples/samples.h"
#include "core/support/file_io.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"
#include "widgets/inputs/number_field.h"

#include <QComboBox>
#include <QLabel>

using namespace esm;

namespace {

class ExportControllerTest : public EditorTest {
protected:
    void SetUp() override { open(makeSample("tube")); }

    TemporaryFolder folder;
    const std::filesystem::path written = folder / "organ.sofa";
};

TEST_F(ExportControllerTest, SaysWhatWillDifferAndAsksHowAnEngineStepsBeforeItWrites) {
    dialogs.expectNamed("exportDialog", [&](QDialog* dialog) {
        EXPECT_FALSE(std::filesystem::exists(written));
        const auto told = [&](const char* label) { return dialog->findChild<QLabel*>(label)->text(); };
        EXPECT_TRUE(told("exportDifferences").contains("instruments"));
        EXPECT_TRUE(told("exportSteps").contains("any length"));
        auto* damping = dialog->findChild<QComboBox*>("exportDamping");
        auto* step = dialog->findChild<NumberField*>("exportTimeStep");
        EXPECT_EQ(step->value(), 0.005);
        damping->setCurrentIndex(1);
        EXPECT_LT(step->value(), 1e-5);
        EXPECT_TRUE(told("exportSteps").contains("not stable"));
        damping->setCurrentIndex(0);
        EXPECT_EQ(step->value(), 0.005);
        step->selectAll();
        QTest::keyClicks(step, "2");
        dialog->findChild<QPushButton*>("exportAccept")->click();
    });
    window->files().exports().exportTo(written);
    const Bytes scene = readFile(written / "organ.scn");
    EXPECT_NE(std::string(scene.begin(), scene.end()).find("dt=\"0.002\""), std::string::npos);
}

TEST_F(ExportControllerTest, WritesNothingWhereTheQuestionIsCancelled) {
    dialogs.expectNamed("exportDialog", [](QDialog* dialog) { dialog->reject(); });
    window->files().exports().exportTo(written);
    EXPECT_FALSE(std::filesystem::exists(written));
}

TEST_F(ExportControllerTest, AsksNothingOfAPackage) {
    window->files().exports().exportTo(folder / "organ.glb");
    EXPECT_TRUE(std::filesystem::exists(folder / "organ.glb"));
}

} // namespace

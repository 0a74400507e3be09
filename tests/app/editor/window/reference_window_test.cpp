#include "app/editor/window/reference_window.h"

#include "core/exchange/image_file.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"

#include <QComboBox>

using namespace esm;

namespace {

class ReferenceWindowTest : public EditorTest {
protected:
    void SetUp() override {
        Project project = makeSample("liver");
        project.layers.resize(2);
        for (std::size_t i = 0; i < 2; ++i) {
            project.layers[i].name = i == 0 ? "first" : "second";
            project.layers[i].photo = makeSamplePhoto("serosa");
        }
        open(project);
        window->windowActions().texture->trigger();
        press(Qt::Key_P, Qt::ShiftModifier);
        choice = child<QComboBox>("referenceChoice");
        ASSERT_NE(choice, nullptr);
    }
    QString shown() const { return child<PhotoView>("referenceView")->spokenValue(); }

    QComboBox* choice = nullptr;
};

} // namespace

TEST_F(ReferenceWindowTest, StaysWhateverToolIsTaken) {
    auto* reference = child<QDialog>("referenceWindow");
    ASSERT_TRUE(reference->isVisible());
    EXPECT_FALSE(reference->isModal());
    for (const int key : {Qt::Key_V, Qt::Key_D, Qt::Key_J}) {
        press(key);
        EXPECT_TRUE(reference->isVisible());
    }
    EXPECT_TRUE(shown().contains("pixels")) << shown().toStdString();
    press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_FALSE(reference->isVisible());
}

TEST_F(ReferenceWindowTest, ShowsTheProjectsPhotosAndOthers) {
    EXPECT_EQ(choice->count(), 3);
    choice->setCurrentIndex(2);
    EXPECT_EQ(choice->currentText(), "second");
    window->document().edit("remove", [](Project& project) { project.layers.pop_back(); });
    EXPECT_EQ(choice->count(), 2);
    EXPECT_EQ(choice->currentIndex(), 0) << "what is gone cannot be shown";
    const TemporaryFolder folder;
    const auto file = folder / "other.png";
    writePng(makeSamplePhoto("serosa")->image, file);
    static_cast<ReferenceWindow*>(child<QDialog>("referenceWindow"))->showFile(file);
    EXPECT_EQ(choice->currentText(), "other.png");
    EXPECT_TRUE(shown().contains("pixels"));
    EXPECT_EQ(project().layers.size(), 1U) << "the project has no more photos than before";
}

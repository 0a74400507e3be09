#include "app/editor/workers/preview.h"
#include "core/exchange/model_package.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "tests/support/temporary_folder.h"
#include "widgets/inputs/value_slider.h"

#include <QPushButton>

using namespace esm;

namespace {

/// The main job without a mouse: every key goes to the widget that has the focus, as from a keyboard.
class KeyboardTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("liver"));
        window->start({});
    }
    void chooseSample() {
        QTest::keyClick(window.get(), Qt::Key_Tab);
        tabTo([](QWidget* focus) {
            const auto* button = qobject_cast<QPushButton*>(focus);
            return button && button->text() == "Liver";
        });
        press(Qt::Key_Space);
        ESM_EVENTUALLY(window->view().isVisible() && window->preview().status().playing);
        tabTo([this](QWidget* focus) { return focus == &window->view(); });
    }
    void tabTo(const std::function<bool(QWidget*)>& isThere) {
        QStringList passed;
        for (int i = 0; i < 120; ++i) {
            QWidget* focus = window->focusWidget();
            if (focus && isThere(focus)) return;
            if (focus) passed << focus->metaObject()->className() + (' ' + focus->objectName());
            press(Qt::Key_Tab);
            QCoreApplication::processEvents(); // what was made new is shown then
        }
        FAIL() << "no number of tabs leads there, but to " << passed.join(", ").toStdString();
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(KeyboardTest, DoesTheMainJobAlone) {
    chooseSample();
    press(Qt::Key_R, Qt::ControlModifier);
    const std::size_t added = project().regions.size() - 1;
    ASSERT_TRUE(project().regions[added].ellipsoid);
    ASSERT_EQ(toolInHand(), "region");

    const Ellipsoid first = *project().regions[added].ellipsoid;
    tabTo([this](QWidget* focus) { return focus == &window->view(); });
    press(Qt::Key_Right);
    press(Qt::Key_Tab); // the middle
    press(Qt::Key_Return);
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    press(Qt::Key_Return);
    const Ellipsoid moved = *project().regions[added].ellipsoid;
    EXPECT_GT((moved.centre - first.centre).norm(), 1e-4);
    press(Qt::Key_Tab);
    press(Qt::Key_Tab); // a handle
    press(Qt::Key_Return);
    press(Qt::Key_Right);
    press(Qt::Key_Up);
    press(Qt::Key_Return);
    const Ellipsoid shaped = *project().regions[added].ellipsoid;
    EXPECT_EQ(shaped.centre, moved.centre);
    const bool isSized = !shaped.radii.isApprox(moved.radii, 1e-6);
    const bool isTurned = shaped.orientation.angularDistance(moved.orientation) > 0.01;
    EXPECT_TRUE(isSized || isTurned) << "as the handle does that Tab came to";

    tabTo([](QWidget* focus) { return focus->objectName() == "systemChoice"; });
    const auto system = project().regions[added].system;
    press(Qt::Key_Down);
    EXPECT_NE(project().regions[added].system, system);
    ASSERT_NE(project().regions[added].system, nullptr);
    tabTo([](QWidget* focus) { return qobject_cast<ValueSlider*>(focus) != nullptr; });
    const auto inputs = project().regions[added].inputs;
    press(Qt::Key_End);
    EXPECT_NE(project().regions[added].inputs, inputs);

    tabTo([this](QWidget* focus) { return focus == &window->view(); });
    press(Qt::Key_P);
    press(Qt::Key_Left);
    press(Qt::Key_Return);
    for (int i = 0; i < 5; ++i)
        press(Qt::Key_Right);
    ASSERT_TRUE(window->preview().loads().pull) << "the tissue is grasped";
    press(Qt::Key_Return);
    EXPECT_FALSE(window->preview().loads().pull);
    const bool wasPlaying = window->preview().status().playing;
    press(Qt::Key_Space);
    ESM_EVENTUALLY(window->preview().status().playing != wasPlaying);

    dialogs.expectFile(folder / "organ.esm");
    press(Qt::Key_S, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_FALSE(window->document().isModified());
    dialogs.expectFile(folder / "organ.glb");
    press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(dialogs.isDone());
    EXPECT_TRUE(validatePackage(folder / "organ.glb").empty());
}

TEST_F(KeyboardTest, EscLetsGoOfWhatTheKeysGrasp) {
    chooseSample();
    press(Qt::Key_P);
    press(Qt::Key_Left);
    press(Qt::Key_Return);
    press(Qt::Key_Left);
    ASSERT_TRUE(window->preview().loads().pull);
    press(Qt::Key_Escape);
    EXPECT_FALSE(window->preview().loads().pull);
}

#include "app/editor/panels/measure/measure_column.h"
#include "core/project/detail_change.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

using namespace esm;

namespace {

class MeasureControllerTest : public EditorTest {
protected:
    void SetUp() override {
        open(withDetail(makeSample("liver"), {Detail::Kind::Nodes, 500}));
        window->windowActions().measure->trigger();
    }
    QTabBar& pages() { return *child<QTabBar>("measurePages"); }
};

TEST_F(MeasureControllerTest, EachPageHasItsChartAndTheTestItsTool) {
    EXPECT_TRUE(child<QWidget>("accuracyView")->isVisible());
    EXPECT_FALSE(child<QWidget>("pressView")->isVisible());
    pages().setCurrentIndex(1);
    EXPECT_FALSE(child<QWidget>("accuracyView")->isVisible());
    EXPECT_TRUE(child<QWidget>("pressView")->isVisible());
    EXPECT_TRUE(child<QWidget>("pressButton")->isVisible());
    EXPECT_EQ(toolInHand(), "finger");
    pages().setCurrentIndex(0);
    EXPECT_TRUE(child<QWidget>("accuracyView")->isVisible());
    EXPECT_EQ(toolInHand(), "pull");
}

TEST_F(MeasureControllerTest, TheToolBringsItsPageAndBelongsToTheWorkspace) {
    press(Qt::Key_Q);
    EXPECT_EQ(pages().currentIndex(), 1);
    EXPECT_EQ(toolInHand(), "finger");
    window->windowActions().tissue->trigger();
    EXPECT_EQ(toolInHand(), "pull");
    EXPECT_FALSE(child<QWidget>("pressView")->isVisible());
    const QAction* finger = window->windowActions().tool("finger");
    EXPECT_FALSE(finger->isEnabled());
    EXPECT_TRUE(finger->toolTip().contains("Measure")) << finger->toolTip().toStdString();
    window->windowActions().measure->trigger();
    EXPECT_EQ(toolInHand(), "finger") << "the page stayed as it was";
}

TEST_F(MeasureControllerTest, AClickAndEnterMeasure) {
    pages().setCurrentIndex(1);
    ESM_EVENTUALLY(window->preview().tissue() != nullptr);
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, window->view().rect().center());
    auto* button = child<QPushButton>("pressButton");
    ESM_EVENTUALLY(button->isEnabled());
    typeInto(child<NumberField>("fingerDepth"), "3 mm");
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Return);
    const auto said = [this] { return child<QLabel>("pressMessage")->text().toStdString(); };
    ESM_EVENTUALLY(child<QLabel>("pressForce")->text() != QString(QChar(0x2013)) || !said().empty());
    EXPECT_EQ(said(), "");
    EXPECT_EQ(child<QLabel>("pressDepth")->text(), "3.00");
}

} // namespace

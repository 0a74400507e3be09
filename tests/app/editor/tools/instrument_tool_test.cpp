#include "app/editor/tools/instrument_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

namespace {

class InstrumentToolTest : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        tool = &take<InstrumentTool>();
    }
    InstrumentTool* tool = nullptr;
};

} // namespace

TEST_F(InstrumentToolTest, TouchesTheSurfaceAndIsPushedIn) {
    tool->chooseRadius(0.02);
    EXPECT_FALSE(instrument());
    moveTo(middle(), Qt::NoButton);
    ASSERT_TRUE(instrument());
    EXPECT_NEAR(instrument()->pose.place.z(), 0.12, 0.002);
    EXPECT_EQ(radiusOf(instrument()->shape), 0.02);
    EXPECT_TRUE(view.scene().instrument) << "and is shown";
    view.setScene(scene);
    EXPECT_TRUE(view.scene().instrument) << "whatever becomes of the organ meanwhile";
    wheel(middle(), 5, Qt::ControlModifier);
    const double pushed = instrument()->pose.place.z();
    EXPECT_LT(pushed, 0.11);
    moveTo(middle() + QPoint(30, 0), Qt::NoButton);
    EXPECT_NEAR(instrument()->pose.place.z(), pushed, 1e-4) << "it sweeps at its depth";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(instrument());
    EXPECT_FALSE(view.scene().instrument);
}

TEST_F(InstrumentToolTest, ComesWithAPressWhereNothingMovedBefore) {
    view.cancel();
    const Camera before = view.camera();
    press(middle());
    ASSERT_TRUE(view.scene().instrument);
    EXPECT_TRUE(instrument());
    moveTo(middle() + QPoint(40, 0));
    ASSERT_TRUE(view.scene().instrument);
    EXPECT_GT(view.scene().instrument->centre.x(), 0.01);
    EXPECT_EQ(view.camera().eye, before.eye) << "the view does not turn instead";
    release(middle() + QPoint(40, 0));
}

TEST_F(InstrumentToolTest, TakesAnotherSizeInTheHand) {
    moveTo(middle(), Qt::NoButton);
    tool->chooseRadius(0.03);
    EXPECT_EQ(view.scene().instrument->radius, 0.03);
    EXPECT_EQ(radiusOf(instrument()->shape), 0.03) << "what pushes the tissue grows with it";
}

TEST_F(InstrumentToolTest, ShowsThroughTheOrgan) {
    tool->chooseRadius(0.03);
    const QColor without = view.grabFramebuffer().pixelColor(middle());
    moveTo(middle(), Qt::NoButton);
    wheel(middle(), 60, Qt::ControlModifier);
    ASSERT_LT(view.scene().instrument->centre.z(), 0.0) << "deep inside";
    EXPECT_NE(view.grabFramebuffer().pixelColor(middle()), without);
}

TEST_F(InstrumentToolTest, GoesWhereTheMouseLeavesTheViewUnlessItIsHeld) {
    QEvent leave(QEvent::Leave);
    moveTo(middle(), Qt::NoButton);
    press(middle());
    QApplication::sendEvent(&view, &leave);
    EXPECT_TRUE(instrument());
    release(middle());
    QApplication::sendEvent(&view, &leave);
    EXPECT_FALSE(instrument());
}

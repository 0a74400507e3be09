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
    EXPECT_TRUE(view.scene().heldInstrument) << "and is shown";
    view.setScene(scene);
    EXPECT_TRUE(view.scene().heldInstrument) << "whatever becomes of the organ meanwhile";
    wheel(middle(), 5, Qt::ControlModifier);
    const double pushed = instrument()->pose.place.z();
    EXPECT_LT(pushed, 0.11);
    moveTo(middle() + QPoint(30, 0), Qt::NoButton);
    EXPECT_NEAR(instrument()->pose.place.z(), pushed, 1e-4) << "it sweeps at its depth";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(instrument());
    EXPECT_FALSE(view.scene().heldInstrument);
}

TEST_F(InstrumentToolTest, ComesWithAPressWhereNothingMovedBefore) {
    view.cancel();
    const Camera before = view.camera();
    press(middle());
    ASSERT_TRUE(view.scene().heldInstrument);
    EXPECT_TRUE(instrument());
    moveTo(middle() + QPoint(40, 0));
    ASSERT_TRUE(view.scene().heldInstrument);
    EXPECT_GT(view.scene().heldInstrument.value().pose.place.x(), 0.01);
    EXPECT_EQ(view.camera().eye, before.eye) << "the view does not turn instead";
    release(middle() + QPoint(40, 0));
}

TEST_F(InstrumentToolTest, TakesAnotherSizeInTheHand) {
    moveTo(middle(), Qt::NoButton);
    tool->chooseRadius(0.03);
    EXPECT_EQ(radiusOf(view.scene().heldInstrument.value().shape), 0.03);
    EXPECT_EQ(radiusOf(instrument()->shape), 0.03) << "what pushes the tissue grows with it";
}

TEST_F(InstrumentToolTest, ShowsThroughTheOrgan) {
    tool->chooseRadius(0.03);
    const QColor without = pictureOf(view).pixelColor(middle());
    moveTo(middle(), Qt::NoButton);
    wheel(middle(), 60, Qt::ControlModifier);
    ASSERT_LT(view.scene().heldInstrument.value().pose.place.z(), 0.0) << "deep inside";
    EXPECT_NE(pictureOf(view).pixelColor(middle()), without);
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

TEST_F(InstrumentToolTest, AShaftsTipIsUnderTheMouseAndItsOtherEndTowardsTheHand) {
    tool->chooseKind(InstrumentKind::Shaft);
    tool->chooseRadius(0.005);
    tool->chooseLength(0.2);
    moveTo(middle(), Qt::NoButton);
    ASSERT_TRUE(instrument());
    const ColliderAxis axis = axisOf(*instrument());
    EXPECT_NEAR(2 * axis.half, 0.2, 1e-12);
    const Vector3d tip = axis.at(-axis.half), hand = axis.at(axis.half);
    EXPECT_NEAR(tip.z(), 0.105, 0.002) << "it touches the ball of 0.1 m";
    EXPECT_GT(hand.z(), tip.z()) << "towards the eye";
    EXPECT_GT(hand.x(), tip.x()) << "and to the lower right";
    EXPECT_LT(hand.y(), tip.y());
    wheel(middle(), 30, Qt::ControlModifier | Qt::ShiftModifier);
    const ColliderAxis straight = axisOf(*instrument());
    EXPECT_NEAR(straight.direction.z(), 1, 1e-9) << "along the line of sight";
    EXPECT_LT((straight.at(-straight.half) - tip).norm(), 1e-9) << "about its tip";
}

TEST_F(InstrumentToolTest, TakesSizesThatFitTheOrganUntilOneIsChosen) {
    tool->chooseKind(InstrumentKind::Shaft);
    const double fitting = radiusOf(tool->shape());
    edit([](Project& project) {
        TriangleMesh mesh = *project.mesh;
        for (Vector3d& vertex : mesh.vertices)
            vertex *= 2;
        SpringNetwork network = networkFromMesh(mesh);
        project.mesh = std::make_shared<TriangleMesh>(mesh);
        project.network = std::make_shared<SpringNetwork>(network);
    });
    EXPECT_NEAR(radiusOf(tool->shape()), 2 * fitting, 0.0006);
    tool->chooseRadius(0.002);
    tool->chooseKind(InstrumentKind::Ball);
    EXPECT_EQ(radiusOf(tool->shape()), 0.002) << "the user's own";
}

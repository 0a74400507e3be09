#include "app/editor/tools/brush_tool.h"

#include "app/editor/tools/painting.h"
#include "tests/app/editor/tools/tool_fixture.h"

#include <QCheckBox>
#include <QTabletEvent>

using namespace esm;

namespace {

/// A photo on the ball, a brush in hand, and a pen on a tablet.
class PenTest : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        edit([](Project& p) {
            p.layers.resize(1);
            p.layers[0].photo = makeSamplePhoto("serosa");
        });
        selection.setPhoto(project().layers[0].id);
        brush = &take<BrushTool>();
        options.reset(brush->makeOptions());
        painting = brush->findChild<Painting*>();
        ASSERT_TRUE(painting);
    }
    /// What the tablet says, and then the mouse, as Qt does where the view leaves the first to it.
    void pen(QEvent::Type type, QEvent::Type asMouse, const QPoint& at, double pressure) {
        const bool isUp = type == QEvent::TabletRelease;
        const Qt::MouseButton button = type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton;
        const Qt::MouseButtons buttons = isUp ? Qt::NoButton : Qt::LeftButton;
        QTabletEvent tablet(type, at, view.mapToGlobal(at), QTabletEvent::Stylus, QTabletEvent::Pen, pressure,
                            0, 0, 0, 0, 0, Qt::NoModifier, 1, button, buttons);
        QApplication::sendEvent(&view, &tablet);
        EXPECT_FALSE(tablet.isAccepted()) << "Qt makes a mouse of it";
        QMouseEvent mouse(asMouse, at, view.mapToGlobal(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(&view, &mouse);
    }
    void down(const QPoint& at, double pressure) {
        pen(QEvent::TabletPress, QEvent::MouseButtonPress, at, pressure);
    }
    void lead(const QPoint& at, double pressure) { pen(QEvent::TabletMove, QEvent::MouseMove, at, pressure); }
    void up(const QPoint& at) { pen(QEvent::TabletRelease, QEvent::MouseButtonRelease, at, 0); }
    void draw(double from, double to) {
        down(middle() - QPoint(60, 0), from);
        lead(middle() + QPoint(60, 0), to);
        up(middle() + QPoint(60, 0));
    }
    const BrushStroke& last() const { return *project().layers[0].strokes.back(); }
    QCheckBox& box(const char* name) const { return *options->findChild<QCheckBox*>(name); }

    BrushTool* brush = nullptr;
    Painting* painting = nullptr;
    std::unique_ptr<QWidget> options;
};

} // namespace

TEST_F(PenTest, PressureChangesTheSizeEvenlyAlongTheStroke) {
    draw(0.2, 0.8);
    const BrushStroke& stroke = last();
    ASSERT_TRUE(validate(stroke).empty());
    ASSERT_EQ(stroke.shares.size(), stroke.path.size());
    ASSERT_GT(stroke.shares.size(), 10U);
    EXPECT_NEAR(stroke.shares.front().radius, 0.2, 1e-9);
    EXPECT_NEAR(stroke.shares.back().radius, 0.8, 0.05);
    for (std::size_t i = 1; i < stroke.shares.size(); ++i) {
        EXPECT_GE(stroke.shares[i].radius, stroke.shares[i - 1].radius);
        EXPECT_LT(stroke.shares[i].radius - stroke.shares[i - 1].radius, 0.1) << "no step is seen";
        EXPECT_EQ(stroke.shares[i].strength, 1) << "that is another box";
    }
    expectSteps(2); // the photo, and one stroke
}

TEST_F(PenTest, PressureChangesWhatTheBoxesSay) {
    EXPECT_TRUE(box("pressureSize").isChecked());
    EXPECT_FALSE(box("pressureStrength").isChecked());
    box("pressureSize").click();
    box("pressureStrength").click();
    draw(0.25, 0.25);
    ASSERT_FALSE(last().shares.empty());
    for (const BrushShares& shares : last().shares)
        EXPECT_EQ(shares, (BrushShares{1, 0.25}));
    box("pressureStrength").click();
    draw(0.25, 0.25);
    EXPECT_TRUE(last().shares.empty()) << "nothing goes by the pen, nothing is stored";
}

TEST_F(PenTest, TheMousePaintsInFullBeforeAndAfterAPen) {
    const auto drag = [&] {
        press(middle() - QPoint(60, 0));
        moveTo(middle() + QPoint(60, 0));
        release(middle() + QPoint(60, 0));
        return last();
    };
    const BrushStroke before = drag();
    EXPECT_TRUE(before.shares.empty());
    draw(0.3, 0.3);
    EXPECT_FALSE(last().shares.empty());
    EXPECT_EQ(drag(), before);
}

TEST_F(PenTest, APenThatPressesHarderInPlaceMakesALargerDot) {
    down(middle(), 0.02);
    EXPECT_EQ(last().path.size(), 1U);
    EXPECT_EQ(last().shares.front().radius, 0.1) << "the lightest touch is seen";
    lead(middle(), 0.7);
    lead(middle(), 0.4);
    up(middle());
    ASSERT_EQ(last().path.size(), 1U);
    EXPECT_NEAR(last().shares.front().radius, 0.7, 1e-9);
    expectSteps(2);
}

TEST_F(PenTest, WhereItLeavesTheOrganAStrokeOfItsOwnGoesOn) {
    down(middle() - QPoint(40, 0), 0.5);
    lead(QPoint(3, 3), 0.5);
    lead(middle() + QPoint(40, 0), 0.9);
    up(middle() + QPoint(40, 0));
    ASSERT_EQ(project().layers[0].strokes.size(), 2U);
    for (const auto& stroke : project().layers[0].strokes)
        EXPECT_TRUE(validate(*stroke).empty());
    EXPECT_EQ(last().shares.size(), last().path.size());
}

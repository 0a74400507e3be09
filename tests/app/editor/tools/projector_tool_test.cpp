#include "app/editor/tools/projector_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

namespace {

/// Two photos in front of the ball, each added by a step of its own, and a drag of the second that has begun.
class TwoProjectors : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        for (const double height : {0.1, 0.0})
            edit([&](Project& project) {
                TextureLayer& layer = project.layers.emplace_back();
                layer.id = document.newLayerId();
                layer.photo = makeSamplePhoto("serosa");
                layer.projector.pose.translation() = Vector3d(0, height, 0.15);
                layer.projector.width = 0.06;
                layer.projector.height = 0.04;
            });
        actions.texture->setChecked(true);
        take<ProjectorTool>();
        selection.setPhoto(project().layers[1].id);
        press(placeOf({0, 0, 0.15}));
        moveTo(placeOf({0.03, 0.01, 0.15}));
        expectSteps(3);
    }
    Vector3d placeOfPhoto(std::size_t i) const { return project().layers[i].projector.pose.translation(); }
};

} // namespace

TEST_F(TwoProjectors, ThePhotoThatWasTakenHoldOfIsMovedWhateverIsSelected) {
    selection.setPhoto(project().layers[0].id);
    moveTo(placeOf({0.05, 0, 0.15}));
    EXPECT_EQ(placeOfPhoto(0), Vector3d(0, 0.1, 0.15));
    EXPECT_NEAR(placeOfPhoto(1).x(), 0.05, 0.002);
    release({0, 0});
    expectSteps(3);
}

TEST_F(TwoProjectors, EscapePutsBackWhatIsDragged) {
    view.cancel();
    EXPECT_EQ(placeOfPhoto(1), Vector3d(0, 0, 0.15));
    expectSteps(2);
    moveTo(placeOf({0.05, 0, 0.15}));
    EXPECT_EQ(placeOfPhoto(1), Vector3d(0, 0, 0.15)) << "the drag is over";
}

TEST_F(TwoProjectors, WhatGoesIsDraggedNoFurther) {
    document.undoStack()->undo();
    document.undoStack()->undo();
    ASSERT_EQ(project().layers.size(), 1U);
    selection.setPhoto(project().layers[0].id);
    moveTo(placeOf({0.05, 0, 0.15}));
    release({0, 0});
    EXPECT_EQ(placeOfPhoto(0), Vector3d(0, 0.1, 0.15));
    expectSteps(3);
}

TEST_F(ToolTest, ProjectorIsMovedAndScaled) {
    edit([](Project& project) {
        project.layers.resize(1);
        project.layers[0].photo = makeSamplePhoto("serosa");
        Projector& projector = project.layers[0].projector;
        projector.pose.translation() = Vector3d(0, 0, 0.15);
        projector.width = 0.06;
        projector.height = 0.04;
    });
    document.undoStack()->clear();
    actions.texture->setChecked(true);
    take<ProjectorTool>();
    ASSERT_EQ(view.scene().projectors.size(), 1U);
    const auto projector = [this]() -> const Projector& { return project().layers[0].projector; };
    press(placeOf({0, 0, 0.15}));
    moveTo(placeOf({0.03, 0.01, 0.15}));
    EXPECT_TRUE(projector().pose.translation().isApprox(Vector3d(0.03, 0.01, 0.15), 0.02));
    release({0, 0});
    expectSteps(1);
    document.undoStack()->undo();
    EXPECT_EQ(projector().pose.translation(), Vector3d(0, 0, 0.15));
    press(placeOf({0.03, 0.02, 0.15}));
    moveTo(placeOf({0.045, 0.03, 0.15}));
    EXPECT_NEAR(projector().width, 0.075, 0.002);
    EXPECT_NEAR(projector().height, 0.05, 0.002);
    EXPECT_NEAR((projector().pose * Vector3d(-projector().width / 2, 0, 0)).x(), -0.03, 1e-9)
        << "the other side stays";
    moveTo(placeOf({0.045, 0.03, 0.15}), Qt::LeftButton, Qt::ControlModifier);
    EXPECT_NEAR(projector().width, 0.09, 0.002);
    EXPECT_NEAR(projector().height, 0.06, 0.002);
    EXPECT_EQ(projector().pose.translation(), Vector3d(0, 0, 0.15)) << "with Ctrl the middle";
    release({0, 0});
    expectSteps(1);
    document.undoStack()->undo();
    const Vector3d eye = view.camera().eye;
    press(placeOf({0.03, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(placeOf({0.05, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(projector().width, 0.08, 0.002);
    EXPECT_NEAR(projector().height, 0.04, 0.002);
    EXPECT_EQ(view.camera().eye, eye) << "elsewhere Shift shifts the view";
    release({0, 0});
    press(QPoint(20, 430), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(QPoint(60, 430), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(view.camera().eye, eye);
}

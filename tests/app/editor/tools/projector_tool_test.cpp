#include "app/editor/tools/projector_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

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
    EXPECT_NEAR(projector().width, 0.09, 0.002);
    EXPECT_NEAR(projector().height, 0.06, 0.002);
    release({0, 0});
    expectSteps(1);
    document.undoStack()->undo();
    const Vector3d eye = view.camera().eye;
    press(placeOf({0.03, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(placeOf({0.05, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(projector().width, 0.10, 0.002);
    EXPECT_NEAR(projector().height, 0.04, 0.002);
    EXPECT_EQ(view.camera().eye, eye) << "elsewhere Shift shifts the view";
    release({0, 0});
    press(QPoint(20, 430), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(QPoint(60, 430), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(view.camera().eye, eye);
}

#include "app/editor/tools/place_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

#include <QSignalSpy>

using namespace esm;
using Eigen::Vector3d;

TEST_F(ToolTest, PlaceLaysARegionOnTheOrganAtRest) {
    QSignalSpy done(&take<PlaceTool>(), &ViewTool::done);
    view.setNodePositions(shifted(0.05));
    const QPoint at = placeOf({0.08, 0.03, 0.09});
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    ASSERT_EQ(project().regions.size(), 1U);
    const Vector3d first = project().regions[0].ellipsoid->centre;
    EXPECT_NEAR(first.norm(), 0.1, 0.002) << "on the ball where it rests";
    EXPECT_LT((first - Vector3d(0.03, 0.03, 0.09)).norm(), 0.01);
    ASSERT_EQ(done.count(), 1) << "to be shaped next";
    EXPECT_EQ(done[0][0].toString(), "region");
    view.setNodePositions(scene.mesh->vertices);
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle());
    ASSERT_EQ(project().regions.size(), 1U) << "the selected one lies there now";
    EXPECT_GT(project().regions[0].ellipsoid->centre.z(), 0.098);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, middle() + QPoint(30, 0));
    EXPECT_EQ(project().regions.size(), 2U);
    const int steps = document.undoStack()->count();
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(4, 4));
    expectSteps(steps);
}

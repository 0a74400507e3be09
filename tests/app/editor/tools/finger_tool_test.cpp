#include "app/editor/tools/finger_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

TEST_F(ToolTest, FingerChoosesWhereTheOrganAtRestIsPressed) {
    const FingerTool& tool = take<FingerTool>();
    EXPECT_EQ(tool.hint(), QString());
    view.setNodePositions(shifted(0.05));
    QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf({0.08, 0.03, 0.09}));
    ASSERT_TRUE(virtualTest.restPlace());
    EXPECT_LT((*virtualTest.restPlace() - Vector3d(0.03, 0.03, 0.09)).norm(), 0.01);
    EXPECT_NE(tool.hint(), QString());
    const Vector3d first = *virtualTest.restPlace();
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(4, 4));
    view.cancel();
    EXPECT_EQ(*virtualTest.restPlace(), first) << "neither a click beside the organ nor Esc takes it away";
    expectSteps(0);
}

TEST_F(ToolTest, FingerStandsWhereItPressesAsLargeAsItIs) {
    take<FingerTool>();
    const QImage bare = pictureOf(view);
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle());
    const auto changedPixels = [&] {
        const QImage now = pictureOf(view);
        int changed = 0;
        for (int y = 60; y < 390; ++y) // without the hint
            for (int x = 0; x < now.width(); ++x)
                if (now.pixel(x, y) != bare.pixel(x, y)) ++changed;
        return changed;
    };
    const int small = changedPixels();
    EXPECT_GT(small, 50);
    virtualTest.setRadius(2 * virtualTest.settings().radius);
    EXPECT_NEAR(changedPixels(), 4 * small, 0.6 * small);
}

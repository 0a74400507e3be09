#include "app/editor/tools/pull_tool.h"

#include "app/editor/tools/look_tool.h"
#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

namespace {

class PullToolTest : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        take<PullTool>();
    }
};

} // namespace

TEST_F(PullToolTest, TakesTheNodeUnderTheMouse) {
    const auto& vertices = scene.mesh->vertices;
    const Vector3d wanted = Vector3d(0.03, 0.02, 0.09); // near the viewer, a little off the middle
    std::uint32_t node = 0;
    for (std::uint32_t i = 0; i < vertices.size(); ++i)
        if ((vertices[i] - wanted).norm() < (vertices[node] - wanted).norm()) node = i;
    const QPoint at = placeOf(vertices[node]);
    press(at);
    EXPECT_FALSE(pull()) << "a press alone pulls nowhere";
    moveTo(at + QPoint(60, -30));
    ASSERT_TRUE(pull());
    EXPECT_EQ(pull()->node, node);
    const QPoint reached = placeOf(pull()->target);
    EXPECT_LE((reached - at - QPoint(60, -30)).manhattanLength(), 3) << "the target stands under the mouse";
    EXPECT_NEAR((pull()->target - vertices[node]).dot(viewDirection()), 0, 1e-6)
        << "and moves parallel to the picture";
    release(at + QPoint(60, -30));
    EXPECT_FALSE(pull());
    expectSteps(0);
}

TEST_F(PullToolTest, FollowsTheMovedSurface) {
    view.setNodePositions(shifted(0.15));
    const auto pullsAt = [this](const QPoint& at) {
        press(at);
        moveTo(at + QPoint(10, 0));
        const bool pulls = pull().has_value();
        release(at);
        return pulls;
    };
    EXPECT_FALSE(pullsAt(middle() - QPoint(60, 0))) << "the organ is no longer there";
    view.showView(StandardView::Front);
    EXPECT_TRUE(pullsAt(placeOf(Vector3d(0.12, 0, 0.08))));
}

TEST_F(PullToolTest, LetsGoAtEscapeAndForAnotherTool) {
    const auto begin = [this] {
        press(middle());
        moveTo(middle() + QPoint(20, 0));
        ASSERT_TRUE(pull());
    };
    begin();
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(pull());
    moveTo(middle() + QPoint(30, 0));
    release(middle());
    EXPECT_FALSE(pull());
    begin();
    take<LookTool>();
    EXPECT_FALSE(pull());
}

TEST_F(PullToolTest, LetsGoWhenAnotherOrganComes) {
    press(middle());
    moveTo(middle() + QPoint(20, 0));
    ASSERT_TRUE(pull());
    document.replace(makeSample("tube"), std::nullopt);
    EXPECT_FALSE(pull());
    moveTo(middle() + QPoint(30, 0));
    EXPECT_FALSE(pull());
}

TEST_F(PullToolTest, PullsAModelWithoutTrianglesByItsNodes) {
    RenderScene bare;
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = {{-0.05, 0, 0}, {0.05, 0, 0}};
    network->springs = {{0, 1, 0.1}};
    bare.network = network;
    view.setScene(bare);
    press(placeOf({0.05, 0, 0}) + QPoint(4, 3));
    moveTo(placeOf({0.05, 0, 0}) + QPoint(14, 3));
    ASSERT_TRUE(pull());
    EXPECT_EQ(pull()->node, 1U);
    release({0, 0});
    press(placeOf({0, 0.04, 0}));
    moveTo(placeOf({0, 0.04, 0}) + QPoint(10, 0));
    EXPECT_FALSE(pull());
}

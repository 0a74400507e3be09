#include "app/editor/tools/fix_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;
using Nodes = std::vector<std::uint32_t>;

namespace {

class FixToolTest : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        document.undoStack()->clear();
        tool = &take<FixTool>();
        tool->setRadius(0.02);
    }
    Nodes fixed() const { return fixedNodesOf(*project().network, project().scene); }
    Vector3d rest(std::uint32_t node) const { return project().network->restPositions[node]; }
    void dragOver(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
        press(from, Qt::LeftButton, keys);
        moveTo(to, Qt::LeftButton, keys);
    }

    FixTool* tool = nullptr;
};

} // namespace

TEST_F(FixToolTest, FixesWhatItIsLedOverInOneStepAndFreesItWithCtrl) {
    dragOver(placeOf({-0.06, 0, 0.08}), placeOf({0.06, 0, 0.08}));
    release(placeOf({0.06, 0, 0.08}));
    expectSteps(1);
    EXPECT_EQ(document.undoStack()->undoText(), "Fix nodes");
    const Nodes held = fixed();
    EXPECT_GT(held.size(), 20U);
    for (std::uint32_t node = 0; node < project().network->restPositions.size(); ++node) {
        const bool isHeld = std::binary_search(held.begin(), held.end(), node);
        if (isHeld) {
            EXPECT_LE(std::abs(rest(node).y()), 0.021);
            EXPECT_GT(rest(node).z(), 0) << "not on the other side";
        }
        // Along the whole of the way, though the mouse told its ends alone.
        const Vector3d nearest = 0.1 * Vector3d(rest(node).x(), 0, rest(node).z()).normalized();
        const bool isOnTheWay = rest(node).z() > 0.08 && (rest(node) - nearest).norm() < 0.015;
        EXPECT_TRUE(isHeld || !isOnTheWay);
    }
    dragOver(placeOf({-0.06, 0, 0.08}), placeOf({0.06, 0, 0.08}), Qt::ControlModifier);
    release(placeOf({0.06, 0, 0.08}));
    EXPECT_TRUE(fixed().empty());
    expectSteps(2);
    document.undoStack()->undo();
    EXPECT_EQ(fixed(), held);
}

TEST_F(FixToolTest, FixesWhatIsSeenWhereItMovedTo) {
    view.setNodePositions(shifted(0.05));
    press(placeOf({0.05, 0, 0.1}));
    release(placeOf({0.05, 0, 0.1}));
    const Nodes held = fixed();
    ASSERT_FALSE(held.empty());
    for (const std::uint32_t node : held)
        EXPECT_LT((rest(node) - Vector3d(0, 0, 0.1)).norm(), 0.022);
}

TEST_F(FixToolTest, BeginsWideEnoughForTheNodesOfACoarseOrgan) {
    edit([this](Project& project) {
        TriangleMesh coarse = ball(4, 5);
        for (Vector3d& vertex : coarse.vertices)
            vertex *= 0.1;
        project.network = scene.network = edgeNetwork(coarse);
        project.mesh = scene.mesh = std::make_shared<TriangleMesh>(std::move(coarse));
    });
    view.setScene(scene);
    const TriangleMesh& mesh = *project().mesh;
    int pressed = 0;
    for (const Triangle& triangle : mesh.triangles) {
        const Vector3d centre =
            (mesh.vertices[triangle[0]] + mesh.vertices[triangle[1]] + mesh.vertices[triangle[2]]) / 3;
        if (centre.dot(viewDirection()) < 0.02) continue;
        ++pressed;
        press(placeOf(centre));
        release(placeOf(centre));
        EXPECT_FALSE(fixed().empty()) << "at " << centre.transpose();
        document.undoStack()->undo();
    }
    EXPECT_GT(pressed, 4);
}

TEST_F(FixToolTest, EscapePutsBackWhatWasFixed) {
    edit([](Project& project) { project.scene.fixed = {{{5}, {}}}; });
    const std::vector<NodeSelection> before = project().scene.fixed;
    dragOver(placeOf({-0.06, 0, 0.08}), placeOf({0.06, 0, 0.08}));
    ASSERT_GT(fixed().size(), 1U);
    view.cancel();
    EXPECT_EQ(project().scene.fixed, before);
    expectSteps(1);
}

TEST_F(FixToolTest, BesideTheOrganTheViewTurns) {
    dragOver({4, 4}, {60, 40});
    release({60, 40});
    EXPECT_TRUE(fixed().empty());
    expectSteps(0);
}

TEST_F(FixToolTest, ShowsHowFarItReaches) {
    const QImage before = pictureOf(view);
    moveTo(middle(), Qt::NoButton);
    EXPECT_NE(pictureOf(view), before);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&view, &leave);
    EXPECT_EQ(pictureOf(view), before);
}

TEST_F(FixToolTest, UndoInTheMidstOfAStrokeEndsIt) {
    dragOver(placeOf({-0.06, 0, 0.08}), placeOf({0, 0, 0.1}));
    document.undoStack()->undo();
    moveTo(placeOf({0.06, 0, 0.08}));
    EXPECT_TRUE(fixed().empty());
    EXPECT_TRUE(document.undoStack()->canRedo());
    release(placeOf({0.06, 0, 0.08}));
}

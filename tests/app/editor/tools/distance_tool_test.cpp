#include "app/editor/tools/distance_tool.h"

#include "core/samples/samples.h"
#include "core/texture/texture_limits.h"
#include "tests/app/editor/tools/tool_fixture.h"
#include "tests/app/editor_driver.h"
#include "tests/support/same_project.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>

using namespace esm;
using Eigen::Vector3d;

namespace {

class DistanceToolTest : public ToolTest {
protected:
    void SetUp() override {
        ToolTest::SetUp();
        tool = &take<DistanceTool>();
    }
    void click(const QPoint& at) { QTest::mouseClick(&view, Qt::LeftButton, {}, at); }
    void dragBetween(const QPoint& from, const QPoint& to) {
        press(from);
        moveTo((from + to) / 2);
        moveTo(to);
        release(to);
    }
    /// Half a pixel of the view at the ball, twice.
    double reach() const { return 0.1 / (placeOf({0.1, 0, 0}).x() - middle().x()); }
    QString refusal(double factor) const {
        try {
            scaled(project(), factor);
        } catch (const std::exception& problem) {
            return problem.what();
        }
        return {};
    }
    void expectLength(double metres) {
        ASSERT_TRUE(tool->length());
        EXPECT_NEAR(*tool->length(), metres, 2 * reach());
    }

    const Vector3d left{-0.06, 0, 0.08}, right{0.06, 0, 0.08}, top{0, 0.06, 0.08};
    DistanceTool* tool = nullptr;
};

} // namespace

TEST_F(DistanceToolTest, MeasuresByTwoClicksOrADrag) {
    click(placeOf(left));
    EXPECT_FALSE(tool->length());
    EXPECT_TRUE(tool->hint().contains("second"));
    click(placeOf(right));
    expectLength(0.12);
    click(placeOf(top));
    EXPECT_FALSE(tool->length()) << "a third click begins anew";
    dragBetween(placeOf(top), placeOf(right));
    EXPECT_FALSE(tool->length()) << "what a drag takes hold of is moved";
    click(placeOf(left));
    expectLength(0.12);
    view.cancel();
    const Vector3d eye = view.camera().eye;
    dragBetween(placeOf(top), placeOf(left));
    expectLength((top - left).norm());
    EXPECT_EQ(view.camera().eye, eye);
    expectSteps(0);
}

TEST_F(DistanceToolTest, APointIsMovedAgain) {
    dragBetween(placeOf(left), placeOf(top));
    dragBetween(placeOf(top), placeOf(right));
    expectLength(0.12);
    moveTo(placeOf(right), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::PointingHandCursor);
    press(placeOf(right));
    moveTo(QPoint(4, 4));
    moveTo(placeOf(top));
    release(placeOf(top));
    expectLength((top - left).norm());
}

TEST_F(DistanceToolTest, BesideTheOrganNothingIsPicked) {
    click(QPoint(4, 4));
    EXPECT_EQ(tool->hint(), "");
    click(placeOf(left));
    click(QPoint(4, 4));
    EXPECT_FALSE(tool->length());
    const Vector3d eye = view.camera().eye;
    dragBetween(QPoint(20, 300), QPoint(80, 300));
    EXPECT_NE(view.camera().eye, eye) << "the view turns";
    EXPECT_FALSE(tool->length());
}

TEST_F(DistanceToolTest, EscapeAndAnotherOrganDropThePoints) {
    dragBetween(placeOf(left), placeOf(right));
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(tool->length());
    dragBetween(placeOf(left), placeOf(right));
    expectLength(0.12);
    document.replace(makeSample("tube"), std::nullopt);
    EXPECT_FALSE(tool->length());
}

TEST_F(DistanceToolTest, MeasuresTheOrganAtRestWhileItMoves) {
    std::vector<Vector3d> grown = shifted(0);
    for (Vector3d& position : grown)
        position = 0.5 * position + Vector3d(0.03, 0, 0);
    view.setNodePositions(grown);
    const auto moved = [](const Vector3d& point) { return Vector3d(0.5 * point + Vector3d(0.03, 0, 0)); };
    dragBetween(placeOf(moved(left)), placeOf(moved(right)));
    ASSERT_TRUE(tool->length());
    EXPECT_NEAR(*tool->length(), 0.12, 4 * reach()) << "twice what is seen";
    moveTo(placeOf(moved(right)), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::PointingHandCursor) << "the points stand where the surface is";
    view.setNodePositions(shifted(0));
    moveTo(placeOf(moved(right)), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::CrossCursor);
    moveTo(placeOf(right), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::PointingHandCursor) << "and go where it carries them";
}

TEST_F(DistanceToolTest, SaysWhyTheOrganCannotBeScaled) {
    EXPECT_TRUE(tool->obstacle().contains("two points"));
    click(placeOf(left));
    EXPECT_TRUE(tool->obstacle().contains("two points"));
    click(placeOf(right));
    EXPECT_TRUE(tool->obstacle().contains("true length"));
    tool->setTrueLength(*tool->length());
    EXPECT_TRUE(tool->obstacle().contains("already"));
    edit([](Project& project) {
        project.layers.resize(1);
        project.layers[0].photo = makeSamplePhoto("serosa");
        project.layers[0].projector.width = 0.3;
    });
    tool->setTrueLength(1000);
    EXPECT_EQ(tool->obstacle(), refusal(1000 / *tool->length()))
        << "what the photo cannot be, as the core says it";
    EXPECT_NE(tool->obstacle(), "");
    tool->setTrueLength(0.2);
    EXPECT_EQ(tool->obstacle(), "");
}

TEST_F(DistanceToolTest, LooksForObstaclesOnceEditsRest) {
    dragBetween(placeOf(left), placeOf(right));
    tool->setTrueLength(0.2);
    ASSERT_EQ(tool->obstacle(), "");
    const QSignalSpy found(tool, &DistanceTool::changed);
    for (int i = 1; i <= 20; ++i)
        edit([i](Project& project) { project.base.viscosity = i; });
    EXPECT_EQ(found.count(), 0) << "a slider is not held up";
    ESM_EVENTUALLY(!tool->isObstacleOld());
    EXPECT_EQ(found.count(), 1);
}

TEST_F(DistanceToolTest, ScalesNothingThatHasJustBecomeImpossible) {
    dragBetween(placeOf(left), placeOf(right));
    tool->setTrueLength(0.2);
    ASSERT_EQ(tool->obstacle(), "");
    edit([](Project& project) {
        project.layers.resize(1);
        project.layers[0].photo = makeSamplePhoto("serosa");
        project.layers[0].projector.width = texture_limits::longestPhoto;
    });
    tool->scaleOrgan();
    expectSteps(1);
    EXPECT_NE(tool->obstacle(), "");
    EXPECT_EQ(tool->obstacle(), refusal(0.2 / *tool->length()));
}

TEST_F(DistanceToolTest, WithoutASurfaceItMeasuresBetweenNodes) {
    edit([](Project& project) { project = makeSample("uterus"); });
    view.frameOrgan();
    const auto& nodes = project().network->restPositions;
    click(placeOf(nodes.front()));
    click(placeOf(nodes.back()));
    ASSERT_TRUE(tool->length());
    const auto isDistance = [&] {
        for (const Vector3d& a : nodes)
            for (const Vector3d& b : nodes)
                if (std::abs((a - b).norm() - *tool->length()) < 1e-12) return true;
        return false;
    };
    EXPECT_TRUE(isDistance());
}

namespace {

class DistanceInTheWindow : public EditorTest {
protected:
    void SetUp() override {
        Project project = makeSample("liver");
        project.stepping.reset();
        open(project);
        window->preview().setPlaying(false);
        window->view().setFocus();
        press(Qt::Key_G);
        ASSERT_EQ(toolInHand(), "distance");
    }
    /// Those of a tool's options that stand in the workspace which is shown.
    template<typename Widget> Widget* shown(const char* name) const {
        for (auto* widget : window->findChildren<Widget*>(name))
            if (widget->isVisible()) return widget;
        return nullptr;
    }
    void pickTwoPoints() {
        const QPoint middle = window->view().rect().center();
        QTest::mouseClick(&window->view(), Qt::LeftButton, {}, middle - QPoint(60, 0));
        QTest::mouseClick(&window->view(), Qt::LeftButton, {}, middle + QPoint(60, 10));
        ASSERT_TRUE(window->findChild<DistanceTool*>()->length());
    }
    void expectScaled(KeptByScaling kept) {
        const Project before = project();
        pickTwoPoints();
        const double length = *window->findChild<DistanceTool*>()->length();
        EXPECT_FALSE(shown<QPushButton>("scaleOrgan")->isEnabled());
        EXPECT_EQ(shown<QPushButton>("scaleOrgan")->toolTip(), shown<QLabel>("scaleRemark")->text());
        auto* field = shown<NumberField>("trueLength");
        typeInto(field, "75.5");
        QTest::keyClick(field, Qt::Key_Return);
        auto* choice = shown<QComboBox>("keptByScaling");
        choice->setCurrentIndex(choice->findData(static_cast<int>(kept)));
        emit choice->activated(choice->currentIndex());
        ASSERT_TRUE(shown<QPushButton>("scaleOrgan")->isEnabled());
        shown<QPushButton>("scaleOrgan")->click();
        expectSameProject(project(), scaled(before, 0.0755 / length, kept));
        EXPECT_NE(project().mesh->vertices, before.mesh->vertices);
        EXPECT_EQ(window->document().undoStack()->count(), 1);
        EXPECT_EQ(window->document().undoStack()->undoText(), "Scale organ");
        EXPECT_EQ(shown<QLabel>("measuredLength")->text(), "75.50 mm") << "the points stay on the organ";
        press(Qt::Key_Z, Qt::ControlModifier);
        expectSameProject(project(), before);
        EXPECT_NEAR(window->findChild<DistanceTool*>()->length().value_or(0), length, 1e-15);
    }
};

} // namespace

TEST_F(DistanceInTheWindow, ScalesTheOrganByOneStep) {
    expectScaled(KeptByScaling::Mass);
}

TEST_F(DistanceInTheWindow, KeepsTheDensityWhereAskedTo) {
    expectScaled(KeptByScaling::Density);
}

TEST_F(DistanceInTheWindow, ScalesToNothingButTheLengthThatIsSeen) {
    pickTwoPoints();
    auto* field = shown<NumberField>("trueLength");
    typeInto(field, "200");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(shown<QPushButton>("scaleOrgan")->isEnabled());
    typeInto(field, "0");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_NE(field->refusal(), "");
    EXPECT_FALSE(shown<QPushButton>("scaleOrgan")->isEnabled());
    EXPECT_EQ(shown<QLabel>("scaleRemark")->text(), field->refusal());
    typeInto(field, "150");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(shown<QPushButton>("scaleOrgan")->isEnabled());
}

TEST_F(DistanceInTheWindow, IsThereInBothWorkspacesWhileItIsInHand) {
    EXPECT_TRUE(shown<QPushButton>("scaleOrgan"));
    press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_FALSE(shown<QPushButton>("scaleOrgan"));
    window->view().setFocus();
    press(Qt::Key_G);
    EXPECT_EQ(toolInHand(), "distance");
    EXPECT_TRUE(shown<QPushButton>("scaleOrgan"));
    press(Qt::Key_1, Qt::ControlModifier);
}

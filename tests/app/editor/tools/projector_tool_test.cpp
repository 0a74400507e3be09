#include "app/editor/tools/projector_tool.h"

#include "tests/app/editor/tools/tool_fixture.h"

#include <cmath>

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

namespace {

/// A photo before the ball, of either kind, that looks at its nearest point.
class ProjectorHandleDrags : public ToolTest {
protected:
    void lay(ProjectorKind kind) {
        edit([&](Project& project) {
            project.layers.resize(1);
            TextureLayer& layer = project.layers[0];
            layer.id = document.newLayerId();
            layer.photo = makeSamplePhoto("serosa");
            layer.projector = {};
            layer.projector.kind = kind;
            layer.projector.pose.translation() = Vector3d(0, 0, 0.2);
            layer.projector.width = 0.06;
            layer.projector.height = 0.04;
        });
        document.undoStack()->clear();
        actions.texture->setChecked(true);
        selection.setPhoto(project().layers[0].id);
        take<ProjectorTool>();
    }
    const Projector& projector() const { return project().layers[0].projector; }
    /// Where a handle is seen; the test fails without one.
    QPoint placeOfHandle(ProjectorHandle::Kind kind) {
        const Sight sight = view.sight();
        const PhotoFace face = faceOf(sight.scene.projectors.at(0));
        for (const auto& handle : projectorHandles(face, view.camera(), 26 * sight.pixelAt(handles(face)[6])))
            if (handle.kind == kind) return placeOf(handle.at);
        ADD_FAILURE() << "there is no such handle";
        return {};
    }
    void hover(const QPoint& at) { moveTo(at, Qt::NoButton); }
    double missesTarget() const {
        const Vector3d way = target - projector().pose.translation();
        return way.cross(projector().pose.linear().col(2)).norm();
    }

    const Vector3d target{0, 0, 0.1}; ///< the ball's nearest point
};

} // namespace

TEST_F(ProjectorHandleDrags, TheRingTurnsAboutWhatTheProjectorLooksAt) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        lay(kind);
        const Projector before = projector();
        const QPoint ring = placeOfHandle(ProjectorHandle::Kind::Turn);
        hover(ring);
        EXPECT_TRUE(view.tool().hint().contains("turn")) << view.tool().hint().toStdString();
        EXPECT_EQ(view.cursor().shape(), Qt::PointingHandCursor);
        press(ring);
        moveTo(ring + QPoint(20, 0));
        moveTo(ring + QPoint(30, 6));
        EXPECT_GT(turnBetween(before, projector()), 3);
        EXPECT_LT(missesTarget(), 0.002);
        EXPECT_NEAR((projector().pose.translation() - target).norm(), 0.1, 0.002);
        EXPECT_TRUE(view.tool().hint().startsWith("Turned by")) << view.tool().hint().toStdString();
        moveTo(ring + QPoint(30, 6), Qt::LeftButton, Qt::ControlModifier);
        EXPECT_TRUE(projector().pose.translation().isApprox(before.pose.translation()))
            << "with Ctrl about its own place";
        EXPECT_GT(missesTarget(), 0.002);
        release(ring + QPoint(30, 6));
        expectSteps(1);
        document.undoStack()->undo();
        EXPECT_TRUE(projector() == before);
    }
}

TEST_F(ProjectorHandleDrags, TheDotRolls) {
    for (const auto kind : {ProjectorKind::Parallel, ProjectorKind::Perspective}) {
        lay(kind);
        const Projector before = projector();
        const QPoint dot = placeOfHandle(ProjectorHandle::Kind::Roll);
        press(dot, Qt::LeftButton, Qt::ShiftModifier);
        moveTo(dot + QPoint(-30, 8), Qt::LeftButton, Qt::ShiftModifier);
        moveTo(dot + QPoint(-60, 20), Qt::LeftButton, Qt::ShiftModifier);
        const double rolled = turnBetween(before, projector());
        EXPECT_NEAR(rolled, 15 * std::round(rolled / 15), 1e-6);
        EXPECT_GT(rolled, 14);
        EXPECT_TRUE(projector().pose.linear().col(2).isApprox(before.pose.linear().col(2)));
        EXPECT_TRUE(projector().pose.translation().isApprox(before.pose.translation(), 1e-6));
        view.cancel();
        EXPECT_TRUE(projector() == before);
        expectSteps(0);
        release({0, 0});
    }
}

TEST_F(ProjectorHandleDrags, TheDiamondPushesAndSoDoesTheWheelWithCtrl) {
    lay(ProjectorKind::Perspective);
    view.showView(StandardView::Right);
    const QPoint diamond = placeOfHandle(ProjectorHandle::Kind::Push);
    hover(diamond);
    EXPECT_EQ(view.cursor().shape(), Qt::SizeHorCursor);
    press(diamond);
    moveTo(diamond + QPoint(-10, 0));
    moveTo(diamond + QPoint(-20, 3));
    EXPECT_GT(projector().pose.translation().z(), 0.2) << "to the left, away from the organ";
    EXPECT_LT(missesTarget(), 1e-9);
    release({0, 0});
    expectSteps(1);
    const double pushed = projector().pose.translation().z();
    const Camera camera = view.camera();
    wheel(middle(), 1, Qt::ControlModifier);
    wheel(middle(), 1, Qt::ControlModifier);
    EXPECT_LT(projector().pose.translation().z(), pushed);
    EXPECT_EQ(view.camera(), camera);
    expectSteps(2);
    wheel(middle(), 1);
    EXPECT_FALSE(view.camera() == camera) << "the wheel alone is the view's";
}

TEST_F(ProjectorHandleDrags, CursorsTellWhichWayASideIsDrawn) {
    lay(ProjectorKind::Parallel);
    hover(placeOf({0.03, 0.02, 0.2}));
    EXPECT_EQ(view.cursor().shape(), Qt::SizeBDiagCursor);
    hover(placeOf({0.03, 0, 0.2}));
    EXPECT_EQ(view.cursor().shape(), Qt::SizeHorCursor);
    hover(placeOf({0, 0.02, 0.2}));
    EXPECT_EQ(view.cursor().shape(), Qt::SizeVerCursor);
    hover(placeOf({0.01, 0.005, 0.2}));
    EXPECT_EQ(view.cursor().shape(), Qt::SizeAllCursor);
    hover({3, 3});
    EXPECT_EQ(view.cursor().shape(), Qt::ArrowCursor);
    EXPECT_TRUE(view.tool().hint().isEmpty());
}

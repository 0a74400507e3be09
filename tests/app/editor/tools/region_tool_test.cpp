#include "app/editor/tools/region_tool.h"

#include "app/editor/tools/look_tool.h"
#include "tests/app/editor/tools/tool_fixture.h"

using namespace esm;
using Eigen::Vector3d;

namespace {

class RegionToolTest : public ToolTest {
protected:
    void addRegion(const Vector3d& centre, const Vector3d& radii) {
        edit([&](Project& project) {
            // One without an ellipsoid is not drawn, and not counted by what is.
            project.regions.resize(2);
            numberByPlace(project.regions);
            project.regions[1].ellipsoid = Ellipsoid{};
            project.regions[1].ellipsoid->centre = centre;
            project.regions[1].ellipsoid->radii = radii;
            project.regions[1].rim = 0;
        });
        document.undoStack()->clear();
        selection.setRegion(document.project().regions[1].id);
        take<RegionTool>();
    }
    const Ellipsoid& shape() const { return *project().regions[1].ellipsoid; }
    void dragFrom(const QPoint& from, const QPoint& by, Qt::KeyboardModifiers keys = {}) {
        press(from, Qt::LeftButton, keys);
        moveTo(from + by / 2, Qt::LeftButton, keys);
        moveTo(from + by, Qt::LeftButton, keys);
        release(from + by);
    }
};

} // namespace

TEST_F(RegionToolTest, MovesAndScalesInOneStepEach) {
    const Vector3d centre(0.05, 0, 0.08);
    addRegion(centre, {0.03, 0.02, 0.02});
    dragFrom(placeOf(centre), {0, 40}, Qt::ControlModifier);
    const Vector3d moved = shape().centre;
    EXPECT_LT(moved.y(), -0.01);
    EXPECT_NEAR(moved.z(), 0.08, 1e-9) << "straight across the picture";
    expectSteps(1);
    EXPECT_EQ(document.undoStack()->undoText(), "Shape region");
    const QPoint end = placeOf(moved + Vector3d(0.03, 0, 0));
    dragFrom(end, placeOf(moved + Vector3d(0.05, 0, 0)) - end);
    EXPECT_NEAR(shape().radii.x(), 0.05, 0.001);
    EXPECT_EQ(shape().radii.y(), 0.02);
    EXPECT_EQ(shape().centre, moved);
    expectSteps(2);
    document.undoStack()->undo();
    document.undoStack()->undo();
    EXPECT_EQ(shape().centre, centre);
}

TEST_F(RegionToolTest, MovedItFollowsTheSurfaceAsDeepAsItWas) {
    const Vector3d centre(0, 0, 0.09); // of a ball of 0.1 m
    addRegion(centre, {0.03, 0.02, 0.02});
    dragFrom(middle(), placeOf({0.08, 0, 0.06}) - middle());
    const QPoint seen = placeOf(shape().centre);
    EXPECT_LE((seen - placeOf({0.08, 0, 0.06})).manhattanLength(), 2) << "where the mouse took it";
    const auto surface = view.sight().pickAt(seen);
    ASSERT_TRUE(surface);
    EXPECT_NEAR((shape().centre - view.camera().eye).norm() - (surface->point - view.camera().eye).norm(),
                0.01, 0.002);
    const Vector3d onTheSurface = shape().centre;
    // Held beside its middle, by a part of it that the organ hides, it goes as far.
    addRegion({0, 0, 0.1}, {0.03, 0.02, 0.02});
    dragFrom(middle() + QPoint(20, 0), placeOf({0, 0.06, 0.08}) - middle());
    EXPECT_NEAR(shape().centre.norm(), 0.1, 0.001) << "on the surface, whatever it was held by";
    addRegion(onTheSurface, {0.03, 0.02, 0.02});
    press(placeOf(onTheSurface));
    moveTo({3, 3});
    EXPECT_LT((shape().centre - onTheSurface).norm(), 0.001) << "beside the organ it stays";
    release({3, 3});
}

TEST_F(RegionToolTest, HangingBeforeTheOrganItGoesAcrossThePicture) {
    const Vector3d centre(0, 0, 0.15);
    addRegion(centre, {0.02, 0.02, 0.02});
    dragFrom(middle(), {40, 0});
    EXPECT_GT(shape().centre.x(), 0.01);
    EXPECT_NEAR(shape().centre.z(), 0.15, 1e-9);
}

TEST_F(RegionToolTest, WhatGoesIsDraggedNoFurther) {
    addRegion({0, 0, -0.2}, {0.03, 0.02, 0.02});
    const Vector3d centre(0.05, 0, 0.08);
    edit([&](Project& project) {
        Region added = project.regions[1];
        added.id = {9};
        added.ellipsoid->centre = centre;
        project.regions.insert(project.regions.begin(), added);
    });
    press(placeOf(centre));
    moveTo(placeOf(centre) + QPoint(0, 20));
    moveTo(placeOf(centre) + QPoint(0, 40));
    expectSteps(2);
    document.undoStack()->undo();
    document.undoStack()->undo();
    ASSERT_EQ(project().regions.size(), 2U);
    moveTo(placeOf(centre) + QPoint(0, 60));
    release(placeOf(centre) + QPoint(0, 60));
    EXPECT_EQ(shape().centre, Vector3d(0, 0, -0.2)) << "the other one, which is now drawn first";
    expectSteps(2);
}

TEST_F(RegionToolTest, TurnsByTheDots) {
    addRegion({0, 0, 0}, {0.06, 0.03, 0.03});
    const QPoint dot = placeOf({0.06, 0, 0}) + QPoint(26, 0);
    dragFrom(dot, {-20, -60});
    EXPECT_GT((shape().orientation * Vector3d::UnitX()).y(), 0.2);
    EXPECT_EQ(shape().radii, Vector3d(0.06, 0.03, 0.03));
    EXPECT_EQ(shape().centre, Vector3d(0, 0, 0));
}

TEST_F(RegionToolTest, OfHandlesCloseTogetherTheNearestIsTaken) {
    const double pixel = 0.06 / (placeOf({0.06, 0, 0}).x() - middle().x());
    addRegion({0, 0, 0}, {0.06, 3.5 * pixel, 0.03});
    dragFrom(placeOf({0, -3.5 * pixel, 0}), {0, 40});
    EXPECT_NEAR(shape().radii.y(), 43.5 * pixel, 3 * pixel);
}

TEST_F(RegionToolTest, WidensTheRimByTheDiamond) {
    addRegion({0, 0, 0}, {0.06, 0.06, 0.06});
    const auto handles = regionHandles(view.scene().ellipsoids[0], view.camera(), 0.02);
    const QPoint diamond = placeOf(handles.back().place);
    press(diamond);
    moveTo(diamond + QPoint(25, -25));
    EXPECT_GT(project().regions[1].rim, 0.005);
    EXPECT_LT(project().regions[1].rim, 0.03);
    moveTo(middle());
    EXPECT_EQ(project().regions[1].rim, 0);
    release(middle());
}

TEST_F(RegionToolTest, PointsAtWhatCanBeTakenHoldOf) {
    addRegion({0, 0, 0}, {0.06, 0.03, 0.03});
    moveTo(middle(), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::ArrowCursor);
    moveTo(placeOf({0.06, 0, 0}), Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::PointingHandCursor);
}

TEST_F(RegionToolTest, AClickSelectsSoDoesTheToolLook) {
    addRegion({0, 0, 0.08}, {0.04, 0.04, 0.04});
    selection.setRegion(std::nullopt);
    QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf({0, 0, 0.08}));
    EXPECT_EQ(selection.region(), document.project().regions[1].id);
    take<LookTool>();
    selection.setRegion(std::nullopt);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(4, 4));
    EXPECT_FALSE(selection.region()) << "beside it";
    QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf({0, 0, 0.08}));
    EXPECT_EQ(selection.region(), document.project().regions[1].id);
    expectSteps(0);
}

TEST_F(RegionToolTest, EscapePutsBackWhatIsDragged) {
    const Vector3d centre(0.05, 0, 0.08);
    addRegion(centre, {0.03, 0.02, 0.02});
    const Ellipsoid before = shape();
    press(placeOf(centre));
    moveTo(placeOf(centre) + QPoint(0, 40));
    ASSERT_NE(shape().centre, centre);
    view.cancel();
    EXPECT_EQ(shape(), before);
    expectSteps(0);
    moveTo(placeOf(centre) + QPoint(0, 60));
    EXPECT_EQ(shape(), before) << "the drag is over";
    dragFrom(placeOf(centre), {0, 40});
    expectSteps(1);
}

TEST_F(RegionToolTest, UndoInTheMidstOfADragEndsIt) {
    const Vector3d centre(0.05, 0, 0.08);
    addRegion(centre, {0.03, 0.02, 0.02});
    const Ellipsoid before = shape();
    press(placeOf(centre));
    moveTo(placeOf(centre) + QPoint(0, 40));
    document.undoStack()->undo();
    moveTo(placeOf(centre) + QPoint(0, 60));
    EXPECT_EQ(shape(), before);
    EXPECT_TRUE(document.undoStack()->canRedo());
    release(placeOf(centre));
}

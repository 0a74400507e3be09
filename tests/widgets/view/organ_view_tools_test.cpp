#include "tests/widgets/view/organ_view_fixture.h"

#include <QSignalSpy>

using namespace esm;
using Eigen::Vector3d;

TEST_F(OrganViewTest, PullTakesTheNodeUnderTheMouse) {
    view.setTool(ViewTool::Pull);
    std::uint32_t node = 0; // the one nearest to the viewer, a little off the middle
    const Vector3d wanted = Vector3d(0.03, 0.02, 0.09);
    for (std::uint32_t i = 0; i < scene.mesh->vertices.size(); ++i)
        if ((scene.mesh->vertices[i] - wanted).norm() < (scene.mesh->vertices[node] - wanted).norm())
            node = i;
    const QPoint at = placeOf(scene.mesh->vertices[node]);
    press(at);
    ASSERT_EQ(pulled, node);
    moveTo(at + QPoint(60, -30));
    ASSERT_TRUE(target);
    const QPoint reached = placeOf(*target);
    EXPECT_LE((reached - at - QPoint(60, -30)).manhattanLength(), 3) << "the target stands under the mouse";
    EXPECT_NEAR((*target - scene.mesh->vertices[node]).dot(viewDirection()), 0, 1e-6)
        << "and moves parallel to the picture";
    EXPECT_EQ(releases, 0);
    release(at + QPoint(60, -30));
    EXPECT_EQ(releases, 1);
}

TEST_F(OrganViewTest, PullFollowsTheMovedSurface) {
    view.setTool(ViewTool::Pull);
    std::vector<Vector3d> moved = scene.mesh->vertices;
    for (Vector3d& position : moved)
        position.x() += 0.15;
    view.setNodePositions(moved);
    press(middle() - QPoint(60, 0));
    EXPECT_FALSE(pulled) << "the organ is no longer there";
    release(middle() - QPoint(60, 0));
    const QPoint at = placeOf(moved[scene.mesh->vertices.size() / 2] + Vector3d::Zero());
    press(placeOf(Vector3d(0.12, 0, 0.08)));
    EXPECT_TRUE(pulled);
    release(at);
}

TEST_F(OrganViewTest, EscapeAndAnotherToolLetGo) {
    view.setTool(ViewTool::Pull);
    press(middle());
    moveTo(middle() + QPoint(20, 0));
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(releases, 1);
    release(middle());
    EXPECT_EQ(releases, 1);
    press(middle());
    view.setTool(ViewTool::Select);
    EXPECT_EQ(releases, 2);
}

TEST_F(OrganViewTest, ModelWithoutTrianglesIsPulledByItsNodes) {
    RenderScene bare;
    auto network = std::make_shared<SpringNetwork>();
    network->restPositions = {{-0.05, 0, 0}, {0.05, 0, 0}};
    network->springs = {{0, 1, 0.1}};
    bare.network = network;
    view.setScene(bare);
    view.setTool(ViewTool::Pull);
    press(placeOf({0.05, 0, 0}) + QPoint(4, 3));
    EXPECT_EQ(pulled, 1U);
    release({0, 0});
    pulled.reset();
    press(placeOf({0, 0.04, 0}));
    EXPECT_FALSE(pulled);
}

TEST_F(OrganViewTest, RegionIsMovedAndScaled) {
    DrawnEllipsoid drawn;
    drawn.shape.centre = {0.05, 0, 0.08};
    drawn.shape.radii = {0.03, 0.02, 0.02};
    drawn.selected = true;
    scene.ellipsoids = {drawn};
    view.setScene(scene);
    view.setTool(ViewTool::Region);
    std::optional<Ellipsoid> shape;
    QObject::connect(&view, &OrganView::regionDragged, [&](int index, const Ellipsoid& ellipsoid) {
        EXPECT_EQ(index, 0);
        shape = ellipsoid;
    });
    QSignalSpy finished(&view, &OrganView::dragFinished);
    const QPoint centre = placeOf(drawn.shape.centre);
    press(centre);
    moveTo(centre + QPoint(0, 40));
    ASSERT_TRUE(shape);
    EXPECT_LT(shape->centre.y(), -0.01);
    EXPECT_NEAR(shape->centre.z(), 0.08, 1e-9);
    EXPECT_EQ(finished.count(), 0);
    release(centre + QPoint(0, 40));
    EXPECT_EQ(finished.count(), 1);
    shape.reset();
    const QPoint end = placeOf(drawn.shape.centre + Vector3d(0.03, 0, 0));
    press(end);
    moveTo(placeOf(drawn.shape.centre + Vector3d(0.05, 0, 0)));
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->radii.x(), 0.05, 0.001);
    EXPECT_EQ(shape->radii.y(), 0.02);
    EXPECT_EQ(shape->centre, drawn.shape.centre);
    release(end);
    EXPECT_EQ(finished.count(), 2);
}

TEST_F(OrganViewTest, ProjectorIsMovedAndScaled) {
    DrawnProjector drawn;
    drawn.projector.pose.translation() = Vector3d(0, 0, 0.15);
    drawn.projector.width = 0.06;
    drawn.projector.height = 0.04;
    drawn.selected = true;
    scene.projectors = {drawn};
    view.setScene(scene);
    view.setTool(ViewTool::Projector);
    std::optional<Projector> projector;
    QObject::connect(&view, &OrganView::projectorDragged,
                     [&](int, const Projector& moved) { projector = moved; });
    press(placeOf({0, 0, 0.15}));
    moveTo(placeOf({0.03, 0.01, 0.15}));
    ASSERT_TRUE(projector);
    EXPECT_TRUE(projector->pose.translation().isApprox(Vector3d(0.03, 0.01, 0.15), 0.02));
    release({0, 0});
    press(placeOf({0.03, 0.02, 0.15}));
    moveTo(placeOf({0.045, 0.03, 0.15}));
    EXPECT_NEAR(projector->width, 0.09, 0.002);
    EXPECT_NEAR(projector->height, 0.06, 0.002);
    release({0, 0});
    const Vector3d eye = view.camera().eye;
    press(placeOf({0.03, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(placeOf({0.05, 0.02, 0.15}), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(projector->width, 0.10, 0.002);
    EXPECT_NEAR(projector->height, 0.04, 0.002);
    EXPECT_EQ(view.camera().eye, eye) << "elsewhere Shift shifts the view";
}

TEST_F(OrganViewTest, InstrumentTouchesTheSurfaceAndIsPushedIn) {
    std::optional<Vector3d> centre;
    QObject::connect(&view, &OrganView::instrumentMoved, [&](const Vector3d& at) { centre = at; });
    QSignalSpy removed(&view, &OrganView::instrumentRemoved);
    view.setInstrumentRadius(0.02);
    view.setTool(ViewTool::Instrument);
    moveTo(middle(), Qt::NoButton);
    ASSERT_TRUE(centre);
    EXPECT_NEAR(centre->z(), 0.12, 0.002);
    EXPECT_TRUE(view.scene().instrument) << "and is shown";
    view.setScene(scene);
    EXPECT_TRUE(view.scene().instrument) << "whatever becomes of the organ meanwhile";
    wheel(middle(), 5, Qt::ControlModifier);
    const double pushed = centre->z();
    EXPECT_LT(pushed, 0.11);
    moveTo(middle() + QPoint(30, 0), Qt::NoButton);
    EXPECT_NEAR(centre->z(), pushed, 1e-4) << "it sweeps at its depth";
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(removed.count(), 1);
    EXPECT_FALSE(view.scene().instrument);
}

TEST_F(OrganViewTest, InstrumentComesWithAPressWhereNothingMovedBefore) {
    QSignalSpy moved(&view, &OrganView::instrumentMoved);
    view.setTool(ViewTool::Instrument);
    view.letGo();
    const Camera before = view.camera();
    press(middle());
    ASSERT_TRUE(view.scene().instrument);
    EXPECT_GE(moved.count(), 1);
    moveTo(middle() + QPoint(40, 0));
    EXPECT_TRUE(view.scene().instrument);
    EXPECT_GT(view.scene().instrument->centre.x(), 0.01);
    EXPECT_EQ(view.camera().eye, before.eye) << "the view does not turn instead";
    release(middle() + QPoint(40, 0));
}

TEST_F(OrganViewTest, InstrumentTakesAnotherSizeInTheHand) {
    QSignalSpy moved(&view, &OrganView::instrumentMoved);
    view.setTool(ViewTool::Instrument);
    moveTo(middle(), Qt::NoButton);
    const int before = moved.count();
    view.setInstrumentRadius(0.03);
    EXPECT_EQ(view.scene().instrument->radius, 0.03);
    EXPECT_EQ(moved.count(), before + 1) << "what pushes the tissue grows with it";
}

TEST_F(OrganViewTest, InstrumentShowsThroughTheOrgan) {
    view.setInstrumentRadius(0.03);
    const QColor without = view.grabFramebuffer().pixelColor(middle());
    view.setTool(ViewTool::Instrument);
    moveTo(middle(), Qt::NoButton);
    wheel(middle(), 60, Qt::ControlModifier);
    ASSERT_LT(view.scene().instrument->centre.z(), 0.0) << "deep inside";
    EXPECT_NE(view.grabFramebuffer().pixelColor(middle()), without);
}

TEST_F(OrganViewTest, RegionIsTurnedByItsDots) {
    const DrawnEllipsoid drawn = selectEllipsoid({0.06, 0.03, 0.03});
    std::optional<Ellipsoid> shape;
    QObject::connect(&view, &OrganView::regionDragged, [&](int, const Ellipsoid& now) { shape = now; });
    const QPoint dot = placeOf({0.06, 0, 0}) + QPoint(26, 0);
    press(dot);
    moveTo(dot + QPoint(-20, -60));
    release(dot + QPoint(-20, -60));
    ASSERT_TRUE(shape);
    EXPECT_GT((shape->orientation * Vector3d::UnitX()).y(), 0.2);
    EXPECT_EQ(shape->radii, drawn.shape.radii);
    EXPECT_EQ(shape->centre, drawn.shape.centre);
}

TEST_F(OrganViewTest, OfHandlesCloseTogetherTheNearestIsTaken) {
    const double pixel = 0.06 / (placeOf({0.06, 0, 0}).x() - middle().x());
    selectEllipsoid({0.06, 3.5 * pixel, 0.03});
    std::optional<Ellipsoid> shape;
    QObject::connect(&view, &OrganView::regionDragged, [&](int, const Ellipsoid& now) { shape = now; });
    const QPoint lower = placeOf({0, -3.5 * pixel, 0});
    press(lower);
    moveTo(lower + QPoint(0, 40));
    release(lower + QPoint(0, 40));
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->radii.y(), 43.5 * pixel, 3 * pixel);
}

TEST_F(OrganViewTest, RimIsWidenedByTheDiamond) {
    const DrawnEllipsoid drawn = selectEllipsoid({0.06, 0.06, 0.06});
    double rim = -1;
    QObject::connect(&view, &OrganView::rimDragged, [&](int, double metres) { rim = metres; });
    const auto handles = regionHandles(drawn, view.camera(), 0.02);
    const QPoint diamond = placeOf(handles.back().place);
    press(diamond);
    moveTo(diamond + QPoint(25, -25));
    EXPECT_GT(rim, 0.005);
    EXPECT_LT(rim, 0.03);
    moveTo(middle());
    EXPECT_EQ(rim, 0);
    release(middle());
}

TEST_F(OrganViewTest, PlaceTellsTheSpotOfTheOrganAtRest) {
    view.setTool(ViewTool::Place);
    std::vector<Vector3d> moved = scene.mesh->vertices;
    for (Vector3d& position : moved)
        position.x() += 0.05;
    view.setNodePositions(moved);
    std::optional<SurfaceSpot> spot;
    bool isNew = false;
    QObject::connect(&view, &OrganView::spotPicked, [&](const SurfaceSpot& picked, bool anew) {
        spot = picked;
        isNew = anew;
    });
    const QPoint at = placeOf({0.08, 0.03, 0.09});
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    ASSERT_TRUE(spot);
    EXPECT_FALSE(isNew);
    EXPECT_NEAR(spot->point.norm(), 0.1, 0.002) << "on the ball where it rests";
    EXPECT_LT((spot->point - Vector3d(0.03, 0.03, 0.09)).norm(), 0.01);
    EXPECT_GT(spot->outward.dot(spot->point.normalized()), 0.98);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, at);
    EXPECT_TRUE(isNew);
    spot.reset();
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(4, 4));
    EXPECT_FALSE(spot);
}

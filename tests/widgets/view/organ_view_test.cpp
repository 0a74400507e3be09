#include "widgets/view/organ_view.h"

#include "core/texture/patch_scan.h"
#include "tests/core/render/subjects.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// A view of 600 × 450 pixels that shows a ball of 0.1 m, with everything it says written down.
class OrganViewTest : public testing::Test {
protected:
    void SetUp() override {
        qRegisterMetaType<Vector3d>("Eigen::Vector3d");
        TriangleMesh mesh = ball(24, 36);
        for (Vector3d& vertex : mesh.vertices)
            vertex *= 0.1;
        scene.network = edgeNetwork(mesh);
        scene.mesh = std::make_shared<TriangleMesh>(std::move(mesh));
        view.resize(600, 450);
        view.setScene(scene);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
        view.frameOrgan();
        QObject::connect(&view, &OrganView::pullStarted, [this](quint32 node) { pulled = node; });
        QObject::connect(&view, &OrganView::pullMoved, [this](quint32 node, const Vector3d& to) {
            EXPECT_EQ(node, pulled.value());
            target = to;
        });
        QObject::connect(&view, &OrganView::pullReleased, [this] { ++releases; });
    }

    double aspect() const { return double(view.width()) / view.height(); }
    QPoint placeOf(const Vector3d& point) const {
        const Eigen::Vector2d place = picturePoint(view.camera(), point, aspect()).value();
        return {qRound(place.x() * view.width()), qRound(place.y() * view.height())};
    }
    QPoint middle() const { return view.rect().center(); }
    void press(const QPoint& at, Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&view, button, keys, at);
    }
    /// QTest::mouseMove carries no button, so a drag sends its own events.
    void moveTo(const QPoint& at, Qt::MouseButtons buttons = Qt::LeftButton,
                Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, keys);
        QApplication::sendEvent(&view, &event);
    }
    void release(const QPoint& at, Qt::MouseButton button = Qt::LeftButton) {
        QTest::mouseRelease(&view, button, {}, at);
    }
    void wheel(const QPoint& at, int notches, Qt::KeyboardModifiers keys = {}) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }
    Vector3d viewDirection() const { return (view.camera().eye - view.camera().target).normalized(); }
    double distance() const { return (view.camera().eye - view.camera().target).norm(); }

    RenderScene scene;
    OrganView view;
    std::optional<quint32> pulled;
    std::optional<Vector3d> target;
    int releases = 0;
};

} // namespace

TEST_F(OrganViewTest, ShowsTheOrganOverItsBackground) {
    const QImage picture = view.grabFramebuffer();
    ASSERT_FALSE(picture.isNull());
    const QColor organ = picture.pixelColor(picture.rect().center()), corner = picture.pixelColor(5, 200);
    EXPECT_GT(organ.red(), organ.green() + 40);
    EXPECT_LT(corner.red(), 80);
    EXPECT_NE(organ, corner);
}

TEST_F(OrganViewTest, FirstSceneIsFramedAndLaterOnesLeaveTheCamera) {
    const Vector3d eye = view.camera().eye;
    const Eigen::AlignedBox3d box = boundingBox(scene.mesh->vertices);
    EXPECT_TRUE(view.rect().contains(placeOf(box.min())));
    EXPECT_TRUE(view.rect().contains(placeOf(box.max())));
    RenderScene other = scene;
    other.mesh = std::make_shared<TriangleMesh>(ball(8, 8));
    other.network = edgeNetwork(*other.mesh);
    view.setScene(other);
    EXPECT_EQ(view.camera().eye, eye);
}

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

TEST_F(OrganViewTest, WheelZoomsAboutTheMouse) {
    const QPoint at(400, 150);
    const Ray before = pickRay(view.camera(), at.x() / 600.0, at.y() / 450.0, aspect());
    const Vector3d point =
        before.origin + before.direction * distance() / -before.direction.dot(viewDirection());
    const double far = distance();
    wheel(at, 2);
    EXPECT_LT(distance(), 0.9 * far);
    EXPECT_LE((placeOf(point) - at).manhattanLength(), 1);
    wheel(at, -2);
    EXPECT_NEAR(distance(), far, 1e-9);
}

TEST_F(OrganViewTest, ButtonsTurnAndShift) {
    const Camera start = view.camera();
    press(middle(), Qt::RightButton);
    moveTo(middle() + QPoint(80, 0), Qt::RightButton);
    release(middle() + QPoint(80, 0), Qt::RightButton);
    EXPECT_LT(view.camera().eye.x(), -0.01) << "dragging to the right shows the organ's left";
    EXPECT_EQ(view.camera().target, start.target);
    view.setCamera(start);
    press(middle(), Qt::MiddleButton);
    moveTo(middle() + QPoint(0, 45), Qt::MiddleButton);
    release(middle(), Qt::MiddleButton);
    EXPECT_LE((placeOf(start.target) - middle() - QPoint(0, 45)).manhattanLength(), 2);
    view.setCamera(start);
    view.setTool(ViewTool::Pull);
    press(middle(), Qt::LeftButton, Qt::AltModifier);
    moveTo(middle() + QPoint(0, 60));
    release(middle());
    EXPECT_GT(view.camera().eye.y(), start.eye.y() + 0.01);
    EXPECT_FALSE(pulled);
}

TEST_F(OrganViewTest, ShowsStandardViewsAndTheWholeOrgan) {
    QSignalSpy cameraChanges(&view, &OrganView::cameraChanged);
    view.showView(StandardView::Right);
    EXPECT_TRUE(viewDirection().isApprox(Vector3d::UnitX(), 1e-9));
    view.showView(StandardView::Top);
    EXPECT_TRUE(viewDirection().isApprox(Vector3d::UnitY(), 1e-9));
    EXPECT_EQ(cameraChanges.count(), 2);
    wheel(middle(), -20);
    const double far = distance();
    view.frameOrgan();
    EXPECT_LT(distance(), 0.5 * far);
}

TEST_F(OrganViewTest, CubeTurnsToItsFace) {
    view.setCamera(orbited(view.camera(), 0.7, 0.1));
    // The front face now stands in the left half of the cube.
    QTest::mouseClick(&view, Qt::LeftButton, {}, cubeSquare(view.size()).center().toPoint() - QPoint(16, 0));
    EXPECT_TRUE(viewDirection().isApprox(Vector3d::UnitZ(), 1e-9));
}

TEST_F(OrganViewTest, ClicksPickButDragsTurn) {
    std::optional<Vector3d> picked;
    QObject::connect(&view, &OrganView::pointPicked, [&](quint32, const Vector3d& point) { picked = point; });
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle());
    ASSERT_TRUE(picked);
    EXPECT_NEAR(picked->norm(), 0.1, 0.002);
    EXPECT_GT(picked->z(), 0.09);
    picked.reset();
    const Vector3d eye = view.camera().eye;
    press(middle());
    moveTo(middle() + QPoint(50, 0));
    release(middle() + QPoint(50, 0));
    EXPECT_FALSE(picked);
    EXPECT_NE(view.camera().eye, eye);
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

TEST_F(OrganViewTest, TextureIsNotReadBeyondItsPatches) {
    auto atlas = std::make_shared<Atlas>(packAtlas(*scene.mesh, {1024, 1, 2}));
    Image page;
    page.width = page.height = 1024;
    page.pixels.assign(std::size_t{4} * 1024 * 1024, 255);
    for (std::size_t i = 1; i < page.pixels.size(); i += 4)
        page.pixels[i] = 0; // magenta between the patches
    const PageBand whole{0, 0, 1024, {}};
    for (const auto& corners : atlas->corners)
        PatchScan(corners).forEachTexel(whole, 1024, 1.5, [&](const PatchTexel& texel) {
            std::fill_n(page.at(texel.x, texel.y), 3, std::uint8_t{128});
        });
    scene.atlas = atlas;
    scene.texturePages = std::make_shared<const std::vector<Image>>(std::vector<Image>{page});
    scene.unlit = true;
    scene.backgroundTop = scene.backgroundBottom = {128, 128, 128};
    view.setScene(scene);
    const QImage picture = view.grabFramebuffer();
    int strays = 0;
    for (int y = 0; y < 400; ++y)       // above the hint
        for (int x = 0; x < 500; ++x) { // left of the cube
            const QColor colour = picture.pixelColor(x, y);
            strays += std::abs(colour.red() - colour.green()) > 4 ? 1 : 0;
        }
    EXPECT_EQ(strays, 0);
}

TEST_F(OrganViewTest, OverlaysArePainted) {
    const QImage plain = view.grabFramebuffer();
    view.setLegend(ViewLegend{"Spring constant", "N/m", 2.4, 81});
    view.setHint("Drag to pull the tissue");
    const QImage painted = view.grabFramebuffer();
    const QRect legend(20, view.height() - 45, 200, 12);
    EXPECT_NE(plain.copy(legend), painted.copy(legend));
    const QColor right = painted.pixelColor(14 + 230 - 14, view.height() - 14 - 66 + 35);
    EXPECT_GT(right.red(), right.blue() + 80) << "the ramp ends in red";
    view.setHint("Something else");
    const QRect hint(14 + 230 + 14, view.height() - 14 - 26, view.width() - 14 - 230 - 28, 26);
    EXPECT_NE(view.grabFramebuffer().copy(hint), painted.copy(hint));
}

TEST_F(OrganViewTest, OverlaysTakeTheColoursOfTheTheme) {
    view.setLegend(ViewLegend{"Spring constant", "N/m", 2.4, 81});
    const auto legendBackground = [&](const QColor& colour) {
        QPalette palette = view.palette();
        palette.setColor(QPalette::Window, colour);
        view.setPalette(palette);
        return view.grabFramebuffer().pixelColor(14 + 230 - 6, view.height() - 14 - 33);
    };
    EXPECT_LT(legendBackground(Qt::black).lightness(), 60);
    EXPECT_GT(legendBackground(Qt::white).lightness(), 200);
}

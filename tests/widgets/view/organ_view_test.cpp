#include "tests/widgets/view/organ_view_fixture.h"

#include "core/texture/layers/patch_scan.h"

#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>

using namespace esm;
using Eigen::Vector3d;

namespace {

/// Writes down what the view tells it.
class RecordingTool : public ViewTool {
public:
    Hold press(const ToolMouse&) override {
        told += "press ";
        return holds;
    }
    bool takesShift(const ToolMouse&) const override { return takesMore; }
    void move(const ToolMouse&) override { told += "move "; }
    void release() override { told += "release "; }
    void click(const ToolMouse& mouse) override {
        told += "click ";
        picked = mouse.picked();
    }
    void cancel() override { told += "cancel "; }
    bool wheel(const ToolMouse&, double) override {
        if (takesMore) told += "wheel ";
        return takesMore;
    }

    Hold holds = Hold::Nothing;
    bool takesMore = false;
    std::string told;
    std::optional<PickedPoint> picked;
};

} // namespace

TEST_F(OrganViewTest, ShowsTheOrganOverItsBackground) {
    const QImage picture = pictureOf(view);
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
    RecordingTool tool;
    tool.holds = Hold::Drag;
    view.setTool(tool);
    press(middle(), Qt::LeftButton, Qt::AltModifier);
    moveTo(middle() + QPoint(0, 60));
    release(middle());
    EXPECT_GT(view.camera().eye.y(), start.eye.y() + 0.01);
    EXPECT_EQ(tool.told, "");
    view.setTool(noTool);
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

TEST_F(OrganViewTest, TheWholeOrganStaysWholeWhateverTheSize) {
    const Eigen::AlignedBox3d box = boundingBox(scene.mesh->vertices);
    const auto isWhole = [&] {
        return view.rect().contains(placeOf(box.min())) && view.rect().contains(placeOf(box.max()));
    };
    view.frameOrgan();
    view.resize(600, 150);
    ASSERT_TRUE(isWhole());
    view.resize(150, 600);
    EXPECT_TRUE(isWhole());
    // Who came nearer wants to stay there.
    wheel(view.rect().center(), 3);
    const Vector3d eye = view.camera().eye;
    view.resize(600, 150);
    EXPECT_EQ(view.camera().eye, eye);
}

TEST_F(OrganViewTest, CubeTurnsToItsFace) {
    view.setCamera(orbited(view.camera(), 0.7, 0.1));
    // The front face now stands in the left half of the cube.
    QTest::mouseClick(&view, Qt::LeftButton, {}, cubeSquare(view.size()).center().toPoint() - QPoint(16, 0));
    EXPECT_TRUE(viewDirection().isApprox(Vector3d::UnitZ(), 1e-9));
}

TEST_F(OrganViewTest, AToolThatTakesNothingTurnsTheViewOrHearsOfAClick) {
    RecordingTool tool;
    view.setTool(tool);
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle());
    EXPECT_EQ(tool.told, "press click ");
    ASSERT_TRUE(tool.picked);
    EXPECT_NEAR(tool.picked->point.norm(), 0.1, 0.002);
    EXPECT_GT(tool.picked->point.z(), 0.09);
    const Vector3d eye = view.camera().eye;
    press(middle());
    moveTo(middle() + QPoint(50, 0));
    release(middle() + QPoint(50, 0));
    EXPECT_EQ(tool.told, "press click press ");
    EXPECT_NE(view.camera().eye, eye);
    view.setTool(noTool);
}

TEST_F(OrganViewTest, WhatAToolHoldsFollowsOnceItIsNoClick) {
    RecordingTool tool;
    tool.holds = Hold::Drag;
    view.setTool(tool);
    const Vector3d eye = view.camera().eye;
    press(middle());
    moveTo(middle() + QPoint(2, 0));
    EXPECT_EQ(tool.told, "press ");
    release(middle() + QPoint(2, 0));
    EXPECT_EQ(tool.told, "press release click ");
    tool.told.clear();
    press(middle());
    moveTo(middle() + QPoint(20, 0));
    press(middle() + QPoint(20, 0), Qt::RightButton);
    release(middle() + QPoint(20, 0), Qt::RightButton);
    QTest::keyClick(&view, Qt::Key_Escape);
    release(middle() + QPoint(20, 0));
    EXPECT_EQ(tool.told, "press move cancel ");
    EXPECT_EQ(view.camera().eye, eye);
    tool.told.clear();
    tool.holds = Hold::Stroke;
    press(middle());
    moveTo(middle() + QPoint(1, 0));
    release(middle() + QPoint(1, 0));
    EXPECT_EQ(tool.told, "press move release ") << "the first pixel counts, and a press is no click";
    view.setTool(noTool);
    EXPECT_EQ(tool.told, "press move release cancel ");
}

TEST_F(OrganViewTest, ShiftAndTheWheelAreTheViewsUnlessTheToolTakesThem) {
    RecordingTool tool;
    tool.holds = Hold::Drag;
    view.setTool(tool);
    const Vector3d eye = view.camera().eye;
    tool.takesMore = true;
    press(middle(), Qt::LeftButton, Qt::ShiftModifier);
    release(middle());
    wheel(middle(), 1);
    EXPECT_EQ(view.camera().eye, eye);
    EXPECT_EQ(tool.told, "press release click wheel ");
    tool.takesMore = false;
    wheel(middle(), 1);
    EXPECT_NE(view.camera().eye, eye);
    const Vector3d target = view.camera().target;
    press(middle(), Qt::LeftButton, Qt::ShiftModifier);
    moveTo(middle() + QPoint(30, 0), Qt::LeftButton, Qt::ShiftModifier);
    release(middle());
    EXPECT_NE(view.camera().target, target);
    view.setTool(noTool);
}

TEST_F(OrganViewTest, TextureIsNotReadBeyondItsPatches) {
    auto atlas = std::make_shared<Atlas>(packAtlas(*scene.mesh, {1024, 1, 2}));
    Image page;
    page.width = page.height = 1024;
    page.pixels.assign(std::size_t{4} * 1024 * 1024, 255);
    for (std::size_t i = 1; i < page.pixels.size(); i += 4)
        page.pixels[i] = 0; // magenta between the patches
    const PageStrip whole{0, 0, 1024, {}};
    for (const auto& corners : atlas->corners)
        PatchScan(corners).forEachTexel(whole, 1024, 1.5, [&](const PatchTexel& texel) {
            std::fill_n(page.at(texel.x, texel.y), 3, std::uint8_t{128});
        });
    scene.atlas = atlas;
    scene.texturePages = std::make_shared<const TiledPages>(tiled({page}));
    scene.unlit = true;
    scene.backgroundTop = scene.backgroundBottom = {128, 128, 128};
    view.setScene(scene);
    const QImage picture = pictureOf(view);
    int strays = 0;
    for (int y = 0; y < 400; ++y)       // above the hint
        for (int x = 0; x < 500; ++x) { // left of the cube
            const QColor colour = picture.pixelColor(x, y);
            strays += std::abs(colour.red() - colour.green()) > 4 ? 1 : 0;
        }
    EXPECT_EQ(strays, 0);
}

TEST_F(OrganViewTest, MarksFollowTheNodesAndTheSpringsPaint) {
    const std::size_t nodes = scene.network->restPositions.size(), springs = scene.network->springs.size();
    const auto painted = [&](const Paint& paint) {
        return std::make_shared<const std::vector<Paint>>(springs, paint);
    };
    scene.showSprings = true;
    scene.springPaint = painted({250, 230, 40, 255});
    scene.marked = MarkedNodes{std::make_shared<const std::vector<double>>(nodes, 1.0)};
    scene.fixedNodes = {0, std::uint32_t(nodes / 2)};
    view.setScene(scene);
    pictureOf(view);
    const auto afresh = [this] {
        OrganView other;
        other.resize(view.size());
        other.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&other, patience));
        other.setScene(scene);
        other.setCamera(view.camera());
        return pictureOf(other);
    };
    scene.springPaint = painted({30, 160, 140, 255});
    view.setScene(scene);
    EXPECT_EQ(pictureOf(view), afresh());
    scene.nodePositions = scene.network->restPositions;
    for (auto& position : scene.nodePositions)
        position.x() += 0.02;
    view.setScene(scene);
    EXPECT_EQ(pictureOf(view), afresh());
    scene.fixedNodes = {1};
    view.setScene(scene);
    EXPECT_EQ(pictureOf(view), afresh());
}

TEST_F(OrganViewTest, AnswersWhileItsPictureIsDrawn) {
    QSemaphore begun, mayGoOn;
    RecordingTool tool;
    OrganView slow(nullptr, [&](const PictureContent& content, int) {
        begun.release();
        mayGoOn.tryAcquire(1, patience); // a view that waits for its picture fails the test below
        return DrawnPicture{QImage(content.size.width, content.size.height, QImage::Format_RGB32), {}};
    });
    const auto goingOn = qScopeGuard([&] { mayGoOn.release(100); });
    QSignalSpy pictures(&slow, &OrganView::drawn);
    slow.setTool(tool);
    slow.resize(view.size());
    slow.setScene(scene);
    slow.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&slow, patience));
    slow.repaint();
    ASSERT_TRUE(begun.tryAcquire(1, patience));
    QTest::mouseClick(&slow, Qt::LeftButton, {}, slow.rect().center());
    EXPECT_TRUE(tool.picked) << "the click is answered";
    slow.frameOrgan();
    slow.repaint(); // asks for another picture, while the first stands still
    QCoreApplication::processEvents();
    EXPECT_EQ(pictures.count(), 0);
    EXPECT_FALSE(slow.isUpToDate());
    mayGoOn.release(100);
    EXPECT_TRUE(QTest::qWaitFor([&] { return slow.isUpToDate(); }, patience));
    EXPECT_GT(pictures.count(), 0);
}

TEST_F(OrganViewTest, OverlaysArePainted) {
    const QImage plain = pictureOf(view);
    view.setLegend(ViewLegend{"Spring constant", "N/m", 2.4, 81, {}});
    view.setHint("Drag to pull the tissue");
    const QImage painted = pictureOf(view);
    const QRect legend(20, view.height() - 45, 200, 12);
    EXPECT_NE(plain.copy(legend), painted.copy(legend));
    const QColor right = painted.pixelColor(14 + 230 - 14, view.height() - 14 - 66 + 35);
    EXPECT_GT(right.red(), right.blue() + 80) << "the ramp ends in yellow";
    view.setHint("Something else");
    const QRect hint(14 + 230 + 14, view.height() - 14 - 26, view.width() - 14 - 230 - 28, 26);
    EXPECT_NE(pictureOf(view).copy(hint), painted.copy(hint));
}

TEST_F(OrganViewTest, NamesStandBesideInstruments) {
    const Eigen::Vector3d place(0.05, 0.12, 0);
    view.setInstruments(
        {sphereAt({0, 0, 0}, 0.001), {Capsule{0.002, 0.5}, {place - Eigen::Vector3d(0, 0, 0.25)}}});
    const QPoint above = placeOf(place) - QPoint(0, 20);
    const QColor nameless = pictureOf(view).pixelColor(above);
    view.setInstrumentNames({"", "blade", "one that is not there"});
    EXPECT_NE(pictureOf(view).pixelColor(above), nameless);
    view.setInstruments({});
    EXPECT_EQ(pictureOf(view).pixelColor(above), nameless) << "names go with their instruments";
}

TEST_F(OrganViewTest, OverlaysTakeTheColoursOfTheTheme) {
    view.setLegend(ViewLegend{"Spring constant", "N/m", 2.4, 81, {}});
    const auto legendBackground = [&](const QColor& colour) {
        QPalette palette = view.palette();
        palette.setColor(QPalette::Window, colour);
        view.setPalette(palette);
        return pictureOf(view).pixelColor(14 + 230 - 6, view.height() - 14 - 33);
    };
    EXPECT_LT(legendBackground(Qt::black).lightness(), 60);
    EXPECT_GT(legendBackground(Qt::white).lightness(), 200);
}

#include "app/editor/tools/painting.h"

#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"
#include "widgets/inputs/number_field.h"

#include <QComboBox>
#include <QLabel>

using namespace esm;

namespace {

class PaintingTest : public EditorTest {
protected:
    void SetUp() override {
        Project project = makeSample("liver");
        TextureLayer photo;
        photo.name = "photo";
        photo.photo = makeSamplePhoto("serosa");
        project.layers = {photo};
        open(project);
        window->windowActions().texture->trigger();
        takeBrush();
    }
    void takeBrush() {
        press(Qt::Key_D);
        ASSERT_EQ(toolInHand(), "brush");
    }
    QPoint middle() const { return window->view().rect().center(); }
    void move(const QPoint& to) const {
        QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window->view(), &move);
    }
    void begin() const {
        QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle());
        for (int step = 1; step <= 20; ++step)
            move(middle() + QPoint(4 * step, 0));
    }
    void stroke() const {
        begin();
        QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle() + QPoint(80, 0));
    }
    const BrushStrokes& strokes(std::size_t layer = 0) const { return project().layers.at(layer).strokes; }
    void choose(BrushKind kind) const {
        auto* choice = child<QComboBox>("brushKind");
        const int index = choice->findData(static_cast<int>(kind));
        ASSERT_GE(index, 0);
        choice->setCurrentIndex(index);
        emit choice->activated(index);
    }
};

} // namespace

TEST_F(PaintingTest, TheHintSaysWhatADragDoes) {
    EXPECT_TRUE(window->view().hint().startsWith("Drag over the organ to erase the photo there"));
    choose(BrushKind::Restore);
    EXPECT_TRUE(window->view().hint().startsWith("Drag over the organ to bring back what was erased"));
    window->windowActions().addPaint->trigger();
    EXPECT_TRUE(window->view().hint().startsWith("Drag over the organ to paint"));
}

TEST_F(PaintingTest, ADragIsOneStrokeAndOneStep) {
    const int steps = window->document().undoStack()->count();
    stroke();
    ASSERT_EQ(strokes().size(), 1U);
    const BrushStroke& painted = *strokes()[0];
    EXPECT_EQ(painted.kind, BrushKind::Erase);
    EXPECT_GE(painted.path.size(), 2U);
    EXPECT_LT(painted.path.size(), 20U) << "close points are left out";
    EXPECT_TRUE(validate(painted).empty());
    EXPECT_EQ(window->document().undoStack()->count(), steps + 1);
    EXPECT_EQ(window->document().undoStack()->undoText(), "Erase with the brush");
    stroke();
    EXPECT_EQ(strokes().size(), 2U);
    EXPECT_EQ(window->document().undoStack()->count(), steps + 2) << "each stroke is a step";
    window->document().undoStack()->undo();
    window->document().undoStack()->undo();
    EXPECT_TRUE(strokes().empty());
}

TEST_F(PaintingTest, LiesOnTheSurfaceUnderTheMouse) {
    stroke();
    ASSERT_FALSE(strokes().empty());
    const TriangleMesh& mesh = *project().mesh;
    const double size = boundingBox(mesh.vertices).diagonal().norm();
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    for (const BrushPoint& point : strokes()[0]->path) {
        const auto hit = query.nearest(point.place);
        ASSERT_TRUE(hit);
        EXPECT_LT(hit->distance, 1e-4 * size);
        const Triangle& t = mesh.triangles[hit->triangle];
        const Eigen::Vector3d normal =
            (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        EXPECT_GT(normal.dot(point.normal), 0) << "the brush paints on the side that it sees";
    }
}

// A fast mouse tells few places: the brush goes over the surface between them, not straight through the
// organ.
TEST_F(PaintingTest, AFastStrokeHasNoHoles) {
    const int y = middle().y();
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle() - QPoint(90, 0));
    move(middle() + QPoint(95, 0));
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle() + QPoint(95, 0));
    ASSERT_EQ(strokes().size(), 1U);
    const BrushStroke& fast = *strokes()[0];
    const TriangleMesh& mesh = *project().mesh;
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    for (std::size_t i = 1; i < fast.path.size(); ++i) {
        const Eigen::Vector3d from = fast.path[i - 1].place, to = fast.path[i].place;
        EXPECT_LE((to - from).norm(), fast.radius / 2);
        EXPECT_LT(query.nearest((from + to) / 2)->distance, fast.radius / 10) << "it does not cut across";
    }
    EXPECT_LE(std::abs(placeOf(fast.path.front().place).x() - (middle().x() - 90)), 2);
    EXPECT_LE(std::abs(placeOf(fast.path.back().place).x() - (middle().x() + 95)), 3);
    for (const BrushPoint& point : fast.path)
        EXPECT_LE(std::abs(placeOf(point.place).y() - y), 2) << "it follows the mouse";
}

TEST_F(PaintingTest, AFastCircleHasNoCorners) {
    constexpr int places = 10;
    constexpr double radius = 60; // pixels
    const auto onCircle = [&](int place) {
        const double angle = 2 * M_PI * place / places;
        return middle() + (radius * QPointF(std::cos(angle), std::sin(angle))).toPoint();
    };
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, onCircle(0));
    for (int place = 1; place < places; ++place)
        move(onCircle(place));
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, onCircle(places - 1));
    ASSERT_EQ(strokes().size(), 1U);
    for (const BrushPoint& point : strokes()[0]->path) {
        const QPointF place = placeOf(point.place), fromMiddle = place - middle();
        const bool isOfFirstPiece = fromMiddle.y() > 0 && place.x() > onCircle(1).x();
        EXPECT_NEAR(distance(place, middle()), radius, isOfFirstPiece ? 4 : 1.5);
    }
}

TEST_F(PaintingTest, AFirstPixelBendsNoLongStroke) {
    const QPoint from = middle() - QPoint(60, 0);
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, from);
    move(from + QPoint(1, 1));
    move(from + QPoint(121, 1));
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, from + QPoint(121, 1));
    ASSERT_EQ(strokes().size(), 1U);
    for (const BrushPoint& point : strokes()[0]->path)
        EXPECT_NEAR(placeOf(point.place).y(), from.y() + 1, 2);
}

TEST_F(PaintingTest, ASharpTurnStaysACorner) {
    const QPoint corner = middle() + QPoint(60, 0);
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle() - QPoint(60, 0));
    move(corner);
    move(corner - QPoint(0, 50));
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, corner - QPoint(0, 50));
    ASSERT_EQ(strokes().size(), 1U);
    for (const BrushPoint& point : strokes()[0]->path) {
        const QPointF fromCorner = placeOf(point.place) - corner;
        EXPECT_LE(std::min(std::abs(fromCorner.x()), std::abs(fromCorner.y())), 1.5);
    }
}

TEST_F(PaintingTest, WhereTheBrushLeavesTheOrganItPaintsNothing) {
    const QPoint outside = placeOf(Eigen::Vector3d(0, 0.2, 0));
    const int steps = window->document().undoStack()->count();
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle() - QPoint(60, 0));
    move(outside);
    move(middle() + QPoint(60, 0));
    ASSERT_EQ(strokes().size(), 2U) << "one before, one after";
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle() + QPoint(60, 0));
    const TriangleMesh& mesh = *project().mesh;
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    for (const auto& stroke : strokes())
        for (std::size_t i = 1; i < stroke->path.size(); ++i)
            EXPECT_LT(query.nearest((stroke->path[i - 1].place + stroke->path[i].place) / 2)->distance,
                      stroke->radius / 2);
    EXPECT_EQ(window->document().undoStack()->count(), steps + 1) << "one movement is one step";
    window->document().undoStack()->undo();
    EXPECT_TRUE(strokes().empty());
}

TEST_F(PaintingTest, EscapeDropsAllOfAMovementThatLeftTheOrgan) {
    stroke();
    QTest::mousePress(&window->view(), Qt::LeftButton, {}, middle() - QPoint(60, 0));
    move(placeOf(Eigen::Vector3d(0, 0.2, 0)));
    move(middle() + QPoint(60, 0));
    ASSERT_EQ(strokes().size(), 3U);
    window->document().edit("prepare", [](Project& p) { p.layers[0].opacity = 0.5; });
    press(Qt::Key_Escape);
    EXPECT_EQ(strokes().size(), 1U);
    EXPECT_EQ(project().layers[0].opacity, 0.5);
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle());
}

TEST_F(PaintingTest, EscapeDropsTheStroke) {
    begin();
    ASSERT_EQ(strokes().size(), 1U);
    press(Qt::Key_Escape);
    EXPECT_TRUE(strokes().empty());
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle());
    EXPECT_TRUE(strokes().empty());
    EXPECT_FALSE(window->document().undoStack()->canRedo()) << "nobody wants it back";
}

TEST_F(PaintingTest, EscapeLeavesWhatCameMeanwhile) {
    for (const bool growsOn : {false, true}) {
        const double opacity = growsOn ? 0.5 : 0.25;
        begin();
        window->document().edit("prepare", [=](Project& p) { p.layers[0].opacity = opacity; });
        if (growsOn) move(middle());
        ASSERT_EQ(strokes().size(), 1U);
        press(Qt::Key_Escape);
        EXPECT_TRUE(strokes().empty());
        EXPECT_EQ(project().layers[0].opacity, opacity);
        QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle());
    }
}

TEST_F(PaintingTest, AStrokeThatIsUndoneWhileItIsPaintedIsOver) {
    QUndoStack& steps = *window->document().undoStack();
    const int first = steps.count();
    stroke();
    const BrushStrokes before = strokes();
    begin();
    ASSERT_EQ(strokes().size(), 2U);
    steps.undo();
    move(middle());
    EXPECT_TRUE(strokes() == before) << "the stroke before is another";
    steps.undo();
    move(middle() + QPoint(40, 0));
    EXPECT_TRUE(strokes().empty());
    QTest::mouseRelease(&window->view(), Qt::LeftButton, {}, middle());
    EXPECT_TRUE(strokes().empty());
    EXPECT_EQ(steps.count(), first + 2) << "both can be redone";
    begin();
    EXPECT_EQ(strokes().size(), 1U);
}

TEST_F(PaintingTest, ALayerOffersWhatCanBeDoneToIt) {
    auto* kind = child<QComboBox>("brushKind");
    EXPECT_EQ(kind->count(), 2) << "a photo is erased and restored";
    window->windowActions().addPaint->trigger();
    ASSERT_EQ(project().layers.size(), 2U);
    EXPECT_EQ(project().layers[1].name, "Paint 1");
    EXPECT_FALSE(project().layers[1].photo);
    EXPECT_EQ(toolInHand(), "brush");
    EXPECT_FALSE(window->windowActions().tool("projector")->isEnabled()) << "there is no photo to place";
    EXPECT_EQ(kind->count(), 5);
    EXPECT_TRUE(child<QWidget>("projectorKind")->parentWidget()->parentWidget()->isHidden());
    stroke();
    ASSERT_EQ(strokes(1).size(), 1U);
    EXPECT_EQ(strokes(1)[0]->kind, BrushKind::Colour);
    EXPECT_TRUE(validate(project()).empty());
}

TEST_F(PaintingTest, CopyingNeedsAPlaceToTakeColoursFrom) {
    window->windowActions().addPaint->trigger();
    choose(BrushKind::Clone);
    stroke();
    EXPECT_TRUE(strokes(1).empty());
    QTest::mouseClick(&window->view(), Qt::LeftButton, Qt::ControlModifier, middle() + QPoint(-60, 0));
    EXPECT_TRUE(strokes(1).empty());
    for (const BrushKind kind : {BrushKind::Clone, BrushKind::Heal}) {
        choose(kind);
        stroke();
        ASSERT_FALSE(strokes(1).empty());
        EXPECT_EQ(strokes(1).back()->kind, kind);
        EXPECT_LT(strokes(1).back()->shift.x(), 0) << "the source lies to the left";
    }
    EXPECT_EQ(strokes(1).size(), 2U);
    EXPECT_EQ(window->document().undoStack()->undoText(), "Heal with the brush");
}

TEST_F(PaintingTest, BracketsSizeTheBrush) {
    auto* radius = child<NumberField>("brushRadius");
    const double before = *radius->value();
    press(Qt::Key_BracketRight);
    EXPECT_NEAR(*radius->value(), 1.25 * before, 1e-9);
    press(Qt::Key_BracketLeft);
    press(Qt::Key_BracketLeft);
    EXPECT_NEAR(*radius->value(), 0.8 * before, 1e-9);
    stroke();
    EXPECT_NEAR(strokes()[0]->radius, 0.8 * before, 1e-9);
}

TEST_F(PaintingTest, SaysWhereNothingWillBeSeen) {
    window->document().edit("hide", [](Project& p) { p.layers[0].visible = false; });
    QString said;
    QObject::connect(window->findChild<Painting*>(), &Painting::message,
                     [&](const QString& text) { said = text; });
    stroke();
    EXPECT_TRUE(said.contains("hidden")) << said.toStdString();
    EXPECT_EQ(strokes().size(), 1U);
}

namespace {

/// Right of the organ's outline in the row of the view's middle, as far as asked for.
QPoint besideOrgan(OrganView& view, int pixels) {
    QPoint place = view.rect().center();
    while (view.sight().pickAt(place))
        place.rx() += 1;
    return place + QPoint(pixels - 1, 0);
}

} // namespace

TEST_F(PaintingTest, WhoJustMissesTheOrganPaintsAndDoesNotTurnTheView) {
    OrganView& view = window->view();
    const Camera before = view.camera();
    const QPoint near = besideOrgan(view, 5);
    QTest::mousePress(&view, Qt::LeftButton, {}, near);
    for (int step = 1; step <= 10; ++step)
        move(near - QPoint(6 * step, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, near - QPoint(60, 0));
    EXPECT_EQ(view.camera(), before);
    ASSERT_EQ(strokes().size(), 1U) << "it begins where it reaches the organ";
    EXPECT_GT(strokes()[0]->path.size(), 1U);
    const QPoint far = besideOrgan(view, 40);
    QTest::mousePress(&view, Qt::LeftButton, {}, far);
    move(far + QPoint(20, 0));
    move(far + QPoint(40, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, far + QPoint(40, 0));
    EXPECT_FALSE(view.camera() == before) << "farther off the view turns";
    EXPECT_EQ(strokes().size(), 1U);
}

TEST_F(PaintingTest, ABrushIsNoLargerThanTheOrgan) {
    const double most = boundingBox(project().mesh->vertices).diagonal().norm() / 2;
    auto* radius = child<NumberField>("brushRadius");
    for (int i = 0; i < 40; ++i)
        press(Qt::Key_BracketRight);
    EXPECT_NEAR(*radius->value(), most, 1e-9);
    press(Qt::Key_BracketLeft);
    EXPECT_NEAR(*radius->value(), 0.8 * most, 1e-9);
    typeInto(radius, "5 m");
    QTest::keyClick(radius, Qt::Key_Return);
    EXPECT_FALSE(radius->refusal().isEmpty());
}

TEST_F(PaintingTest, SaysWhichLayerCoversTheStroke) {
    QString said;
    QObject::connect(window->findChild<Painting*>(), &Painting::message,
                     [&](const QString& text) { said = text; });
    window->document().edit("cover", [&](Project& p) {
        TextureLayer cover = p.layers[0];
        cover.id = window->document().newLayerId();
        cover.name = "Cover";
        cover.projector.occlusion = false;
        cover.projector.width = cover.projector.height = 2;
        cover.projector.pose.translation() = Eigen::Vector3d(0, 0, 5);
        p.layers.push_back(cover);
    });
    window->findChild<Selection*>()->setPhoto(project().layers[0].id);
    stroke();
    EXPECT_TRUE(said.contains("Cover")) << said.toStdString();
    said.clear();
    window->document().edit("hide", [](Project& p) { p.layers[1].visible = false; });
    stroke();
    EXPECT_TRUE(said.isEmpty()) << said.toStdString();
}

#include "widgets/view/photo_view.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace esm;
using Eigen::Vector2d;

namespace {

class PhotoViewTest : public testing::Test {
protected:
    PhotoViewTest() {
        Image photo;
        photo.width = 200;
        photo.height = 100;
        photo.pixels.assign(4 * 200 * 100, 128);
        view.resize(624, 424);
        view.setPicture(std::make_shared<const Image>(photo));
        view.show();
        QObject::connect(&view, &PhotoView::pixelPicked, [this](const Vector2d& at) { picked = at; });
        QObject::connect(&view, &PhotoView::markDragged, [this](int number, const Vector2d& to) {
            draggedNumber = number;
            dragged = to;
        });
    }

    QPoint placeOf(const Vector2d& pixel) const { return view.placeOf(pixel).toPoint(); }
    void click(const Vector2d& pixel) {
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, placeOf(pixel));
    }
    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
        QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
    }
    void wheel(const QPoint& at, int notches) {
        QWheelEvent event(at, view.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &event);
    }

    PhotoView view;
    std::optional<Vector2d> picked, dragged;
    int draggedNumber = 0;
};

TEST_F(PhotoViewTest, AClickChoosesThePixelUnderIt) {
    EXPECT_EQ(placeOf({0, 0}), QPoint(12, 62)) << "the whole photo, in the middle";
    click({50, 25});
    ASSERT_TRUE(picked);
    EXPECT_LT((*picked - Vector2d(50, 25)).norm(), 0.3);
    picked.reset();
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, QPoint(300, 20));
    EXPECT_FALSE(picked) << "beside the photo";
}

TEST_F(PhotoViewTest, TheWheelComesCloserWhereTheMouseIs) {
    const QPoint at = placeOf({150, 80});
    wheel(at, 6);
    EXPECT_LE((placeOf({150, 80}) - at).manhattanLength(), 2);
    EXPECT_GT((view.placeOf({151, 80}) - view.placeOf({150, 80})).x(), 8) << "a pixel can be hit";
    const Vector2d before = view.pixelAt({300, 200});
    drag({300, 200}, {340, 190});
    EXPECT_LT((view.pixelAt({340, 190}) - before).norm(), 1e-9) << "a drag takes the photo along";
    EXPECT_FALSE(picked) << "and chooses nothing";
    wheel(at, -40);
    EXPECT_EQ(placeOf({0, 0}), QPoint(12, 62)) << "the whole photo again";
}

TEST_F(PhotoViewTest, AMarkFollowsADragAndStaysInThePhoto) {
    view.setMarks({{{40, 40}, {1, false, false}}, {{120, 60}, {2, false, false}}});
    QSignalSpy dropped(&view, &PhotoView::markDropped), selected(&view, &PhotoView::markSelected);
    drag(placeOf({120, 60}), placeOf({130, 70}));
    ASSERT_TRUE(dragged);
    EXPECT_EQ(draggedNumber, 2);
    EXPECT_LT((*dragged - Vector2d(130, 70)).norm(), 0.5);
    EXPECT_EQ(dropped.count(), 1);
    drag(placeOf({40, 40}), QPoint(0, 0));
    EXPECT_EQ(draggedNumber, 1);
    EXPECT_EQ(*dragged, Vector2d(0, 0));
    click({40, 40});
    ASSERT_EQ(selected.count(), 1);
    EXPECT_EQ(selected[0][0].toInt(), 1);
    EXPECT_FALSE(picked);
}

} // namespace

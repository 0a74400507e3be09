#include "widgets/inputs/key_pointer.h"

#include <gtest/gtest.h>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

using namespace esm;

namespace {

/// Writes down what the mouse seems to do.
class Area : public QWidget {
public:
    Area() {
        resize(200, 100);
        setFocusPolicy(Qt::StrongFocus);
        setMouseTracking(true);
        pointer.setStops([] { return std::vector<QPointF>{{10, 20}, {30, 40}, {5000, 0}}; });
    }

    KeyPointer pointer{*this};
    QStringList seen;

protected:
    void mousePressEvent(QMouseEvent* event) override { note("press", *event); }
    void mouseMoveEvent(QMouseEvent* event) override { note("move", *event); }
    void mouseReleaseEvent(QMouseEvent* event) override { note("release", *event); }
    void wheelEvent(QWheelEvent* event) override { seen << QString("wheel %1").arg(event->angleDelta().y()); }
    void keyPressEvent(QKeyEvent* event) override {
        if (!pointer.press(*event)) QWidget::keyPressEvent(event);
    }
    bool focusNextPrevChild(bool next) override { return pointer.goToNextStop(next); }

private:
    void note(const QString& what, const QMouseEvent& event) {
        seen << QString("%1 %2,%3").arg(what).arg(event.x()).arg(event.y()) +
                    (event.modifiers() & Qt::ControlModifier ? " Ctrl" : "") +
                    (event.buttons() & Qt::LeftButton ? " held" : "");
    }
};

class KeyPointerTest : public testing::Test {
protected:
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&area, key, modifiers); }
    QStringList seenSince() { return std::exchange(area.seen, {}); }

    Area area;
};

} // namespace

TEST_F(KeyPointerTest, ArrowsMoveAMarkThatTheFirstOneShows) {
    EXPECT_EQ(area.pointer.place(), std::nullopt);
    press(Qt::Key_Right);
    const QPointF start = *area.pointer.place();
    EXPECT_TRUE(area.rect().contains(start.toPoint()));
    press(Qt::Key_Right);
    EXPECT_EQ(*area.pointer.place() - start, QPointF(10, 0));
    press(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_EQ(*area.pointer.place() - start, QPointF(10, -1));
    for (int i = 0; i < 100; ++i)
        press(Qt::Key_Left);
    EXPECT_EQ(area.pointer.place()->x(), 0) << "it stays within";
}

TEST_F(KeyPointerTest, EnterPressesAndLetsGoWithTheKeysThatWereHeld) {
    press(Qt::Key_Return);
    EXPECT_TRUE(seenSince().isEmpty()) << "there is no mark yet";
    press(Qt::Key_Tab);
    press(Qt::Key_Down);
    press(Qt::Key_Tab);
    seenSince();
    press(Qt::Key_Return, Qt::ControlModifier);
    press(Qt::Key_Right);
    press(Qt::Key_Return);
    press(Qt::Key_Right);
    EXPECT_EQ(seenSince(), (QStringList{"press 10,20 Ctrl held", "move 20,20 Ctrl held", "release 20,20 Ctrl",
                                        "move 30,20"}));
}

TEST_F(KeyPointerTest, TabGoesToWhatCanBeTakenAndThenOn) {
    EXPECT_FALSE(area.pointer.goToNextStop(true)) << "without a mark Tab leaves at once";
    press(Qt::Key_Down);
    EXPECT_TRUE(area.pointer.goToNextStop(true));
    EXPECT_EQ(area.pointer.place(), QPointF(10, 20));
    EXPECT_TRUE(area.pointer.goToNextStop(true));
    EXPECT_FALSE(area.pointer.goToNextStop(true)) << "what is out of sight does not count";
    EXPECT_TRUE(area.pointer.goToNextStop(false));
    EXPECT_EQ(area.pointer.place(), QPointF(10, 20));
    EXPECT_FALSE(area.pointer.goToNextStop(false));
}

TEST_F(KeyPointerTest, WhereTabBringsTheKeysIsSeen) {
    area.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&area));
    const auto corner = [&] {
        QPixmap picture(area.size());
        picture.fill(Qt::black);
        QPainter painter(&picture);
        area.pointer.paintFocus(painter);
        painter.end();
        return picture.toImage().pixelColor(0, 50);
    };
    QApplication::setActiveWindow(&area);
    area.setFocus(Qt::MouseFocusReason);
    EXPECT_EQ(corner(), QColor(Qt::black));
    area.clearFocus();
    area.setFocus(Qt::TabFocusReason);
    EXPECT_EQ(corner(), area.palette().color(QPalette::Link));
}

TEST_F(KeyPointerTest, TheWheelTurnsAndTheMouseTakesTheMarkAway) {
    press(Qt::Key_PageUp);
    press(Qt::Key_Down);
    press(Qt::Key_PageUp);
    press(Qt::Key_PageDown);
    const QStringList seen = seenSince();
    EXPECT_EQ(seen.mid(seen.size() - 2), (QStringList{"wheel 120", "wheel -120"}));
    press(Qt::Key_Return);
    QMouseEvent moved(QEvent::MouseMove, QPointF(3, 3), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&area, &moved);
    EXPECT_EQ(area.pointer.place(), std::nullopt);
    EXPECT_TRUE(seenSince().join(' ').contains("release")) << "nothing stays held";
}

#include "tests/support/eventually.h"
#include "widgets/fuzzy/partition_editor.h"

#include <gtest/gtest.h>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

FuzzyVariable stiffness() {
    return {"stiffness",
            0,
            10,
            {{"soft", {0, 0, 2, 3}}, {"medium", {2, 3, 3, 6}}, {"firm", {5, 8, 10, 10}}},
            "N/m"};
}

/// Takes what the editor asks for, as a panel does.
class PartitionEditorTest : public testing::Test {
protected:
    PartitionEditorTest() {
        editor.resize(418, 168); // 400 pixels from 0 to 10
        editor.setVariable(stiffness());
        QObject::connect(&editor, &PartitionEditor::setEdited,
                         [this](std::size_t term, const Trapezoid& set) {
                             FuzzyVariable variable = editor.variable();
                             variable.terms[term].set = set;
                             editor.setVariable(variable);
                         });
        editor.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&editor, patience));
        QApplication::setActiveWindow(&editor);
    }

    const Trapezoid& set(std::size_t term) const { return editor.variable().terms[term].set; }
    void moveTo(const QPoint& place, Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent event(QEvent::MouseMove, place, editor.mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          modifiers);
        QApplication::sendEvent(&editor, &event);
    }
    void drag(const QPoint& from, int by, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&editor, Qt::LeftButton, modifiers, from);
        moveTo(from + QPoint(by / 2, 0), modifiers);
        moveTo(from + QPoint(by, 0), modifiers);
        QTest::mouseRelease(&editor, Qt::LeftButton, modifiers, from + QPoint(by, 0));
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&editor, key, modifiers);
    }

    PartitionEditor editor;
    QSignalSpy finished{&editor, &PartitionEditor::gestureFinished};
};

} // namespace

TEST_F(PartitionEditorTest, ACornerIsDraggedAndSnapsButNeverCrosses) {
    editor.setTerm(2);
    drag(editor.placeOf(2, Corner::A), -37); // 0.925
    EXPECT_DOUBLE_EQ(set(2).a, 4.1) << "a round value";
    EXPECT_EQ(finished.count(), 1);
    drag(editor.placeOf(2, Corner::A), -42);
    EXPECT_EQ(set(2).a, 3) << "where others have a corner";
    drag(editor.placeOf(2, Corner::A), 390);
    EXPECT_EQ(set(2).a, 8) << "its own next corner";
    EXPECT_EQ(set(2).b, 8);
    drag(editor.placeOf(2, Corner::D), 300);
    EXPECT_EQ(set(2).d, 10);
}

TEST_F(PartitionEditorTest, AModifierLetsACornerBeAnywhere) {
    editor.setTerm(2);
    for (const auto modifier : {Qt::AltModifier, Qt::ControlModifier}) {
        editor.setVariable(stiffness());
        drag(editor.placeOf(2, Corner::A), -37, modifier);
        EXPECT_NEAR(set(2).a, 5 - 37.0 / 40, 1e-9);
    }
}

TEST_F(PartitionEditorTest, OfTwoCornersInOnePlaceTheWayOfTheMouseDecides) {
    editor.setTerm(1);
    const QPoint peak = editor.placeOf(1, Corner::B);
    drag(peak, 40);
    EXPECT_EQ(set(1), (Trapezoid{2, 3, 4, 6}));
    editor.setVariable(stiffness());
    drag(peak, -20);
    EXPECT_EQ(set(1), (Trapezoid{2, 2.5, 3, 6}));
}

TEST_F(PartitionEditorTest, AClickTakesATermInHandAndADragShiftsIt) {
    QSignalSpy taken(&editor, &PartitionEditor::termTaken);
    const QPoint core = (editor.placeOf(2, Corner::B) + editor.placeOf(2, Corner::C)) / 2 + QPoint(0, 20);
    QTest::mouseClick(&editor, Qt::LeftButton, {}, core);
    EXPECT_EQ(taken.count(), 1);
    EXPECT_EQ(editor.term(), 2U);
    EXPECT_EQ(set(2), stiffness().terms[2].set) << "a click alone moves nothing";
    drag(core, -40);
    EXPECT_EQ(set(2), (Trapezoid{4, 7, 10, 10})) << "the shoulder stays";
    drag(editor.placeOf(1, Corner::D), 20);
    EXPECT_EQ(editor.term(), 1U) << "a corner of another term takes that one";
    EXPECT_EQ(set(1).d, 6.5);
}

TEST_F(PartitionEditorTest, EscapeGivesADragBack) {
    editor.setTerm(2);
    const QPoint from = editor.placeOf(2, Corner::B);
    QTest::mousePress(&editor, Qt::LeftButton, {}, from);
    moveTo(from - QPoint(50, 0));
    EXPECT_LT(set(2).b, 7);
    press(Qt::Key_Escape);
    moveTo(from - QPoint(80, 0));
    QTest::mouseRelease(&editor, Qt::LeftButton, {}, from);
    EXPECT_EQ(set(2), stiffness().terms[2].set);
}

TEST_F(PartitionEditorTest, KeysReachEveryCorner) {
    QWidget next(&editor);
    next.setFocusPolicy(Qt::StrongFocus);
    next.show();
    next.setFocus();
    editor.setFocus(Qt::TabFocusReason);
    press(Qt::Key_Down);
    EXPECT_EQ(editor.term(), 1U);
    press(Qt::Key_Left);
    EXPECT_DOUBLE_EQ(set(1).a, 1.9);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(set(1).a, 2) << "the next step of ten";
    press(Qt::Key_Tab);
    press(Qt::Key_Left);
    EXPECT_DOUBLE_EQ(set(1).b, 2.9);
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    EXPECT_DOUBLE_EQ(set(1).b, 3) << "not beyond its neighbour";
    press(Qt::Key_Tab);
    press(Qt::Key_Right);
    EXPECT_DOUBLE_EQ(set(1).c, 3.1);
    press(Qt::Key_Tab);
    press(Qt::Key_End);
    EXPECT_EQ(set(1).d, 10);
    press(Qt::Key_Backtab);
    press(Qt::Key_Home);
    EXPECT_EQ(set(1).c, 3);
    press(Qt::Key_Tab);
    EXPECT_TRUE(editor.hasFocus());
    EXPECT_TRUE(editor.spokenValue().startsWith("medium ends at 10"));
    press(Qt::Key_Tab);
    EXPECT_FALSE(editor.hasFocus()) << "behind the last corner the next control follows";
}

TEST_F(PartitionEditorTest, KeysThatRestEndTheGesture) {
    editor.setFocus();
    editor.setPause(std::chrono::milliseconds(0));
    press(Qt::Key_Right);
    EXPECT_TRUE(finished.wait());
}

TEST_F(PartitionEditorTest, TellsADragAtItsEndWhileItWaits) {
    QSignalSpy edited(&editor, &PartitionEditor::setEdited);
    const Trapezoid before = set(1);
    editor.setWaits(true);
    const QPoint from = editor.placeOf(1, Corner::D);
    QTest::mousePress(&editor, Qt::LeftButton, {}, from);
    moveTo(from + QPoint(20, 0));
    moveTo(from + QPoint(40, 0));
    EXPECT_EQ(edited.count(), 0);
    EXPECT_DOUBLE_EQ(set(1).d, 7) << "it is seen all the same";
    QTest::mouseRelease(&editor, Qt::LeftButton, {}, from + QPoint(40, 0));
    EXPECT_EQ(edited.count(), 1);
    EXPECT_EQ(finished.count(), 1);
    EXPECT_DOUBLE_EQ(set(1).d, 7);
    QTest::mousePress(&editor, Qt::LeftButton, {}, editor.placeOf(1, Corner::D));
    moveTo(from);
    press(Qt::Key_Escape);
    EXPECT_DOUBLE_EQ(set(1).d, 7) << "taken back";
    EXPECT_EQ(edited.count(), 1);
    EXPECT_NE(set(1), before);
}

#include "tests/support/eventually.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/quantity_formats.h"

#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QVBoxLayout>

using namespace esm;

namespace {

class NumberFieldTest : public testing::Test {
protected:
    void SetUp() override { field.setValue(0.01); }

    void type(const QString& text) {
        field.selectAll();
        QTest::keyClick(&field, Qt::Key_Delete);
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }

    NumberField field{lengthFormat(0)};
    QSignalSpy edited{&field, &NumberField::valueEdited};
};

/// A window with an action, and a field that has the focus.
struct ActionBesideField {
    explicit ActionBesideField(const QKeySequence& key) {
        (new QVBoxLayout(&window))->addWidget(number);
        number->setValue(0.01);
        action.setShortcut(key);
        window.addAction(&action);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
        QApplication::setActiveWindow(&window);
        number->setFocus();
    }

    QWidget window;
    NumberField* number = new NumberField(lengthFormat(0), &window);
    QAction action;
    QSignalSpy triggered{&action, &QAction::triggered};
};

} // namespace

TEST_F(NumberFieldTest, TakesWhatIsTypedInTheShownUnit) {
    EXPECT_EQ(field.text(), "10.0 mm");
    type("25");
    ASSERT_EQ(edited.count(), 1);
    EXPECT_DOUBLE_EQ(field.value().value(), 0.025);
    EXPECT_EQ(field.text(), "25.0 mm");
}

TEST_F(NumberFieldTest, ConvertsOtherUnitsOfTheSameQuantity) {
    type("5 cm");
    EXPECT_DOUBLE_EQ(field.value().value(), 0.05);
    EXPECT_EQ(field.text(), "50.0 mm");
    type("0,02 m");
    EXPECT_DOUBLE_EQ(field.value().value(), 0.02);
    type("1 234");
    EXPECT_DOUBLE_EQ(field.value().value(), 1.234);
}

TEST_F(NumberFieldTest, RefusesWithAReasonAndLeavesTheTextToBeCorrected) {
    for (const char* text : {"-3", "abc", "5000000", "4 kg"}) {
        type(text);
        EXPECT_EQ(field.text(), text);
        EXPECT_FALSE(field.refusal().isEmpty()) << text;
        EXPECT_EQ(field.value(), 0.01) << text;
    }
    EXPECT_TRUE(field.refusal().contains("mm")) << field.refusal().toStdString();
    type("-3");
    EXPECT_TRUE(field.refusal().contains("between 0 and")) << field.refusal().toStdString();
    EXPECT_EQ(edited.count(), 0);
    QTest::keyClicks(&field, "7");
    EXPECT_TRUE(field.refusal().isEmpty()) << "it is being corrected";
    type("7");
    EXPECT_DOUBLE_EQ(field.value().value(), 0.007);
}

TEST_F(NumberFieldTest, EscapeTakesBackWhatWasRefused) {
    type("abc");
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.text(), "10.0 mm");
    EXPECT_TRUE(field.refusal().isEmpty());
}

TEST_F(NumberFieldTest, IsNotRoundedByLookingAtIt) {
    field.setValue(0.0123456);
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 0);
    EXPECT_EQ(field.value(), 0.0123456);
}

TEST_F(NumberFieldTest, ArrowsStepWithinTheLimits) {
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_DOUBLE_EQ(field.value().value(), 0.011);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&field, Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_EQ(field.value(), 0.0);
}

TEST_F(NumberFieldTest, SaysWhenTheArrowsRestAndWhenSomethingWasTyped) {
    QSignalSpy finished(&field, &NumberField::gestureFinished);
    field.setPause(std::chrono::hours(1));
    QTest::keyClick(&field, Qt::Key_Up);
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(finished.count(), 0);
    field.setPause(std::chrono::milliseconds(0));
    ASSERT_TRUE(finished.wait());
    EXPECT_EQ(finished.count(), 1);
    type("25");
    EXPECT_EQ(finished.count(), 2);
}

TEST_F(NumberFieldTest, MayLeaveItsUnitToTheCaption) {
    NumberField bare(withoutUnit(lengthFormat(0)));
    bare.setValue(0.01);
    EXPECT_EQ(bare.text(), "10.0");
    bare.selectAll();
    QTest::keyClicks(&bare, "3 cm");
    QTest::keyClick(&bare, Qt::Key_Return);
    EXPECT_EQ(bare.text(), "30.0");
}

// Qt's own fields take Ctrl+E for the end of the line; in the editor it exports.
TEST_F(NumberFieldTest, LeavesItsKeyToExporting) {
    const ActionBesideField exporting(QStringLiteral("Ctrl+E"));
    QTest::keyClick(exporting.number, Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(exporting.triggered.count(), 1);
}

TEST_F(NumberFieldTest, LeavesUndoToTheWindowUntilSomethingIsTyped) {
    const ActionBesideField undo(QKeySequence::Undo);
    QTest::keyClick(undo.number, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(undo.triggered.count(), 1);
    undo.number->selectAll();
    QTest::keyClicks(undo.number, "25");
    QTest::keyClick(undo.number, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(undo.triggered.count(), 1) << "typing is undone in the field";
}

TEST_F(NumberFieldTest, IsWideEnoughForEveryNumberWhereItIsAskedTo) {
    NumberFormat format;
    format.unit = QStringLiteral("N·s/m");
    NumberField narrow(format);
    narrow.setFixedWidth(narrow.widthFor(format.unit));
    for (const double value : {1e-7, 8.888e8, -8.888e-8, 888888888.0}) {
        narrow.setValue(value);
        EXPECT_LT(narrow.fontMetrics().horizontalAdvance(narrow.text()) + 4, narrow.width()) << value;
    }
}

TEST_F(NumberFieldTest, SaysWhyItRefusesANumberOnEnterAndOnTab) {
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Tab}) {
        QWidget window;
        auto* column = new QVBoxLayout(&window);
        auto* left = new NumberField(lengthFormat(0));
        column->addWidget(left);
        column->addWidget(new NumberField(lengthFormat(0)));
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window, patience));
        left->setFocus();
        QToolTip::hideText();
        ESM_EVENTUALLY(!QToolTip::isVisible());
        QTest::keyClicks(left, "-3");
        QTest::keyClick(left, key);
        EXPECT_EQ(left->hasFocus(), key == Qt::Key_Return);
        ESM_EVENTUALLY(QToolTip::isVisible() && QToolTip::text() == left->refusal());
    }
}

TEST_F(NumberFieldTest, SaysANumberThatHasNoRoomInItsToolTip) {
    field.setToolTip(QStringLiteral("How long it is"));
    const auto toolTip = [&] {
        QToolTip::hideText();
        QHelpEvent event(QEvent::ToolTip, {2, 2}, field.mapToGlobal({2, 2}));
        QApplication::sendEvent(&field, &event);
        return QToolTip::text();
    };
    field.show();
    field.resize(200, field.sizeHint().height());
    EXPECT_TRUE(toolTip().startsWith("How long it is")) << toolTip().toStdString();
    EXPECT_TRUE(toolTip().contains(field.format().unit)) << "what may be typed, in its unit";
    field.resize(30, field.sizeHint().height());
    EXPECT_TRUE(toolTip().startsWith(field.text() + "\nHow long it is")) << toolTip().toStdString();
}

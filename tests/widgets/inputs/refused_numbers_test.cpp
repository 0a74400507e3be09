#include "widgets/inputs/refused_numbers.h"

#include "tests/support/eventually.h"
#include "widgets/inputs/number_field.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDialog>
#include <QTest>
#include <QToolTip>
#include <QVBoxLayout>

using namespace esm;

namespace {

NumberFormat fromOneToTen() {
    NumberFormat format;
    format.minimum = 1;
    format.maximum = 10;
    return format;
}

struct TwoNumbers {
    TwoNumbers() {
        auto* column = new QVBoxLayout(&dialog);
        for (NumberField* field : {first, second}) {
            field->setValue(5);
            column->addWidget(field);
        }
        dialog.show();
        dialog.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog, patience));
        first->setFocus();
    }
    static void type(NumberField* field, const char* text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }

    QDialog dialog;
    NumberField* first = new NumberField(fromOneToTen());
    NumberField* second = new NumberField(fromOneToTen());
};

} // namespace

TEST(RefusedNumbers, TakesWhatIsStillBeingTyped) {
    TwoNumbers shown;
    TwoNumbers::type(shown.first, "7");
    EXPECT_TRUE(takesAllNumbers(shown.dialog));
    EXPECT_EQ(shown.first->value(), 7);
}

TEST(RefusedNumbers, GoesBackToTheNumberAndSaysWhy) {
    for (const char* refused : {"99", "1e99", "abc"}) {
        TwoNumbers shown;
        TwoNumbers::type(shown.first, refused);
        shown.second->setFocus();
        EXPECT_FALSE(takesAllNumbers(shown.dialog)) << refused;
        EXPECT_EQ(shown.first->value(), 5);
        EXPECT_EQ(shown.first->text(), refused);
        ESM_EVENTUALLY(shown.first->hasFocus() && shown.first->hasSelectedText());
        ESM_EVENTUALLY(QToolTip::text() == shown.first->refusal());
        TwoNumbers::type(shown.first, "8");
        EXPECT_TRUE(takesAllNumbers(shown.dialog));
        EXPECT_EQ(shown.first->value(), 8);
    }
}

TEST(RefusedNumbers, DoesNotMindFieldsThatCannotBeTypedIn) {
    TwoNumbers shown;
    TwoNumbers::type(shown.first, "99");
    TwoNumbers::type(shown.second, "abc");
    EXPECT_FALSE(takesAllNumbers(shown.dialog));
    shown.first->setEnabled(false);
    EXPECT_FALSE(takesAllNumbers(shown.dialog));
    shown.second->hide();
    EXPECT_TRUE(takesAllNumbers(shown.dialog));
}

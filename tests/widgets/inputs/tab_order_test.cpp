#include "widgets/inputs/tab_order.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QVBoxLayout>

using namespace esm;

TEST(TabOrder, IsThatOfTheLayoutsHoweverLateControlsCame) {
    QWidget whole;
    auto* column = new QVBoxLayout(&whole);
    auto* last = new QLineEdit(&whole);
    auto* inner = new QWidget(&whole);
    auto* rows = new QVBoxLayout(inner);
    auto* row = new QHBoxLayout;
    rows->addLayout(row);
    column->addWidget(inner);
    column->addWidget(last);
    auto* second = new QLineEdit(inner);
    auto* first = new QLineEdit(inner);
    row->addWidget(first);
    row->addWidget(second);
    tabInLayoutOrder(whole);
    const auto next = [](const QWidget* control) {
        do
            control = control->nextInFocusChain();
        while (!(control->focusPolicy() & Qt::TabFocus));
        return control;
    };
    EXPECT_EQ(next(first), second);
    EXPECT_EQ(next(second), last);
}

#include "widgets/fuzzy/rule_table.h"

#include "tests/core/fuzzy/age_and_zeal.h"
#include "tests/support/eventually.h"

#include <gmock/gmock.h>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

namespace {

const std::vector<std::string> fourRules{
    "IF age IS old AND zeal IS NOT much THEN viscosity IS thick WITH 0.5", "",
    "IF age IS old OR zeal IS much THEN mass IS small", "IF age IS older THEN mass IS small",
    "IF zeal IS little THEN viscosity IS thin AND viscosity IS thick"};

class RuleTableTest : public testing::Test {
protected:
    void SetUp() override {
        show(fourRules);
        table.resize(500, 240);
        table.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&table, patience));
        QApplication::setActiveWindow(&table);
    }
    void show(const std::vector<std::string>& lines) { table.setRules(ageAndZealSystem(), lines); }
    QModelIndex cell(int row, int column) const { return table.model()->index(row, column); }
    QString shown(int row, int column) const { return cell(row, column).data().toString(); }
    QToolButton* button(const char* name) const {
        for (auto* button : table.findChildren<QToolButton*>())
            if (button->text() == name || button->accessibleName() == name) return button;
        return nullptr;
    }
    QStringList wanted() const { return edited.isEmpty() ? QStringList() : edited.back()[0].toStringList(); }

    RuleTable table;
    QSignalSpy edited{&table, &RuleTable::edited};
};

} // namespace

TEST_F(RuleTableTest, ShowsWordsInCellsAndTextAcrossThem) {
    EXPECT_EQ(table.model()->rowCount(), 4);
    EXPECT_EQ(shown(0, 0), "old");
    EXPECT_EQ(shown(0, 1), "not much");
    EXPECT_EQ(shown(0, 2), "thick");
    EXPECT_EQ(shown(0, 3), QString(QChar(0x2013)));
    EXPECT_EQ(shown(0, 4), "0.5");
    EXPECT_EQ(shown(1, 0), "age IS old OR zeal IS much");
    EXPECT_EQ(table.view()->columnSpan(1, 0), 2);
    EXPECT_EQ(table.view()->columnSpan(2, 0), 5) << "a line that is no rule";
    EXPECT_EQ(shown(2, 0), "IF age IS older THEN mass IS small");
    EXPECT_EQ(table.view()->columnSpan(3, 2), 2);
    EXPECT_EQ(shown(3, 2), "viscosity IS thin AND viscosity IS thick");
}

TEST_F(RuleTableTest, AWordIsChosenInACell) {
    table.view()->setCurrentIndex(cell(0, 1));
    QTest::keyClick(table.view(), Qt::Key_Return);
    auto* choice = table.view()->findChild<QComboBox*>();
    ASSERT_NE(choice, nullptr);
    EXPECT_EQ(choice->currentText(), "not much");
    EXPECT_EQ(choice->count(), 5);
    choice->setCurrentIndex(1);
    emit choice->activated(1);
    EXPECT_EQ(wanted(), QStringList({"IF age IS old AND zeal IS little THEN viscosity IS thick WITH 0.5",
                                     "IF age IS old OR zeal IS much THEN mass IS small",
                                     "IF age IS older THEN mass IS small",
                                     "IF zeal IS little THEN viscosity IS thin AND viscosity IS thick"}));
    EXPECT_EQ(shown(0, 1), "not much") << "until the rules say so";
}

TEST_F(RuleTableTest, TextsAndWeightsAreTyped) {
    table.model()->setData(cell(1, 0), "NOT age IS  old", Qt::EditRole);
    EXPECT_EQ(wanted()[1], "IF NOT age IS old THEN mass IS small");
    table.model()->setData(cell(2, 0), "IF age IS old THEN mass IS small", Qt::EditRole);
    EXPECT_EQ(wanted()[2], "IF age IS old THEN mass IS small");
    table.view()->edit(cell(0, 4));
    auto* weight = table.view()->findChild<QDoubleSpinBox*>();
    ASSERT_NE(weight, nullptr);
    weight->setValue(0.25);
    QTest::keyClick(weight, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([&] { return wanted()[0].endsWith("WITH 0.25"); }, patience));
    const int before = edited.count();
    table.model()->setData(cell(0, 4), 0.5, Qt::EditRole);
    EXPECT_EQ(edited.count(), before) << "nothing new";
}

TEST_F(RuleTableTest, DeleteEmptiesACell) {
    table.view()->setCurrentIndex(cell(0, 2));
    QTest::keyClick(table.view(), Qt::Key_Delete);
    EXPECT_EQ(wanted()[0], "IF age IS old AND zeal IS NOT much THEN WITH 0.5");
    show({wanted()[0].toStdString()});
    EXPECT_EQ(shown(0, 0), "old") << "an unfinished rule stays in cells";
    EXPECT_EQ(shown(0, 2), QString(QChar(0x2013)));
}

TEST_F(RuleTableTest, RowsAreAddedRemovedAndMoved) {
    table.goTo(0);
    EXPECT_FALSE(button("Move the rule up")->isEnabled());
    QTest::mouseClick(button("Add rule"), Qt::LeftButton);
    ASSERT_EQ(wanted().size(), 5);
    EXPECT_EQ(wanted()[1], "IF THEN");
    table.goTo(1);
    QTest::keyClick(table.view(), Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(wanted()[0], "IF age IS old OR zeal IS much THEN mass IS small");
    EXPECT_EQ(wanted().size(), 4);
    QTest::mouseClick(button("Remove the rule"), Qt::LeftButton);
    EXPECT_EQ(wanted().size(), 3);
    show({});
    QTest::mouseClick(button("Add rule"), Qt::LeftButton);
    EXPECT_EQ(wanted(), QStringList({"IF THEN"}));
}

TEST_F(RuleTableTest, WordsAreWholeInANarrowPanelAndHeadsMakeWayFirst) {
    const std::vector<std::string> rules{"IF age IS old THEN viscosity IS thick"};
    show(rules);
    const auto* view = table.findChild<QTableView*>();
    const auto* heads = view->horizontalHeader();
    const auto allColumns = [&] {
        int width = 0;
        for (int column = 0; column < table.model()->columnCount(); ++column)
            width += view->columnWidth(column);
        return width;
    };
    const int wide = allColumns();
    table.resize(280, 240);
    ESM_EVENTUALLY(allColumns() < wide);
    for (int column = 0; column < table.model()->columnCount(); ++column)
        EXPECT_GT(view->columnWidth(column), view->fontMetrics().horizontalAdvance(shown(0, column)))
            << column;
    EXPECT_EQ(heads->textElideMode(), Qt::ElideRight) << "a head that is cut says so";
    EXPECT_TRUE(cell(0, 0).data(Qt::ToolTipRole).toString().contains("old"));
}

#include "app/editor/panels/fuzzy/domains_panel.h"

#include "app/editor/panels/fuzzy/fuzzy_workbench.h"
#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/rule_text.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QComboBox>
#include <QMenu>
#include <QMouseEvent>

using namespace esm;

namespace {

class DomainsPanelTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        addPublishedRegion();
        meanEveryRegion();
        chooseTab("Domains");
        QTest::qWait(0); // the section gets its place
    }
    const FuzzySystem& system() const { return *project().regions.back().system; }
    const FuzzyVariable& consistency() const { return system().inputs[0]; }
    DomainsPanel* panel() const { return window->findChild<DomainsPanel*>(); }
    PartitionEditor* partition() const { return child<PartitionEditor>("partition"); }
    NumberField* corner(Corner corner) const { return child<CornerFields>("corners")->field(corner); }
    ItemList* terms() const { return child<ItemList>("termList"); }
    QString message() const { return child<QLabel>("domainMessage")->text(); }
    QPushButton* button(const QString& text) const {
        for (auto* button : panel()->findChildren<QPushButton*>())
            if (button->text() == text) return button;
        return nullptr;
    }
    void trigger(const QString& entry) const {
        for (QAction* action : child<QMenu>("variableMenu")->actions())
            if (action->text().remove('&') == entry) action->trigger();
    }
    void dragCorner(std::size_t term, Corner corner, int by) {
        const QPoint from = partition()->placeOf(term, corner);
        QTest::mousePress(partition(), Qt::LeftButton, {}, from);
        for (const int step : {by / 2, by}) {
            QMouseEvent event(QEvent::MouseMove, from + QPoint(step, 0), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(partition(), &event);
        }
        QTest::mouseRelease(partition(), Qt::LeftButton, {}, from + QPoint(by, 0));
    }
    void rename(int row, const QString& name) {
        terms()->item(row)->setText(name);
        QTest::qWait(0);
    }
    int edits() const { return window->document().undoStack()->index(); }
    void undo() const { window->document().undoStack()->undo(); }
};

} // namespace

TEST_F(DomainsPanelTest, ADraggedCornerChangesTheTissueAndIsOneStep) {
    const FuzzySystem before = system();
    auto& region = project().regions.back();
    const auto springConstant = [&] { return evaluate(region, usualWallThickness).values.springConstant; };
    window->document().edit("value", [](Project& p) { setInput(p.regions.back(), "consistency", 5.2); });
    const auto was = springConstant();
    const int steps = edits();
    dragCorner(3, Corner::B, -30); // flexible
    EXPECT_LT(consistency().terms[3].set.b, 5.2);
    EXPECT_NE(springConstant(), was);
    EXPECT_EQ(edits(), steps + 1);
    EXPECT_TRUE(child<QComboBox>("systemChoice")->currentText().startsWith("susilap-g (changed)"));
    EXPECT_TRUE(window->findChild<FuzzyWorkbench*>()
                    ->findChild<QLabel*>("sectionTitle")
                    ->toolTip()
                    .endsWith("(changed)"));
    dragCorner(3, Corner::B, 400);
    EXPECT_EQ(consistency().terms[3].set.b, consistency().terms[3].set.c) << "corners never cross";
    undo();
    undo();
    EXPECT_EQ(system(), before);
    EXPECT_EQ(springConstant(), was);
}

TEST_F(DomainsPanelTest, CornersAreTyped) {
    const FuzzySystem before = system();
    const int steps = edits();
    terms()->setCurrentRow(0);
    typeInto(corner(Corner::D), "3.4");
    QTest::keyClick(corner(Corner::D), Qt::Key_Return);
    EXPECT_EQ(consistency().terms[0].set.d, 3.4);
    typeInto(corner(Corner::C), "3.6");
    QTest::keyClick(corner(Corner::C), Qt::Key_Return);
    EXPECT_TRUE(corner(Corner::C)->refusal().contains("3.4")) << "where the next corner is";
    EXPECT_EQ(consistency().terms[0].set.c, 2.5);
    EXPECT_EQ(edits(), steps + 1);
    undo();
    EXPECT_EQ(system(), before);
    EXPECT_TRUE(isFuzzyPreset(system()));
}

TEST_F(DomainsPanelTest, RulesFollowARenamedTerm) {
    const FuzzySystem before = system();
    rename(3, "quite  bendy");
    EXPECT_EQ(consistency().terms[3].name, "quite_bendy");
    EXPECT_EQ(ruleText(system(), system().rules[0]),
              "IF consistency IS quite_bendy THEN spring_const IS small AND viscosity IS small");
    rename(3, "soft");
    EXPECT_TRUE(message().contains("already")) << message().toStdString();
    EXPECT_EQ(consistency().terms[3].name, "quite_bendy");
    EXPECT_EQ(terms()->item(3)->text(), "quite bendy");
    EXPECT_TRUE(message().contains("already"));
    undo();
    EXPECT_EQ(system(), before);
    EXPECT_TRUE(message().isEmpty()) << "its reason is gone";
    rename(3, "soft");
    EXPECT_FALSE(message().isEmpty());
    window->findChild<Selection*>()->setRegion(project().regions[0].id);
    EXPECT_TRUE(message().isEmpty());
}

TEST_F(DomainsPanelTest, ATermIsAddedAndNamedInOneStep) {
    const FuzzySystem before = system();
    const int steps = edits();
    for (auto* button : panel()->findChildren<QToolButton*>())
        if (button->text() == "+ add") button->click();
    auto* editor = terms()->findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    editor->setText("springy");
    QTest::keyClick(editor, Qt::Key_Return);
    ESM_EVENTUALLY(consistency().terms[partition()->term()].name == "springy");
    EXPECT_EQ(edits(), steps + 1);
    rename(static_cast<int>(partition()->term()), "elastic");
    EXPECT_EQ(edits(), steps + 2);
    undo();
    undo();
    EXPECT_EQ(system(), before);
}

TEST_F(DomainsPanelTest, ATermIsRemovedWithItsRulesOnlyWhenTheUserSaysSo) {
    const FuzzySystem before = system();
    dialogs.expectNamed("rulesGoBox", [](QDialog* box) {
        EXPECT_TRUE(qobject_cast<QMessageBox*>(box)->informativeText().contains("IF consistency IS soft"));
        box->reject();
    });
    terms()->setCurrentRow(1);
    QTest::keyClick(terms(), Qt::Key_Delete);
    EXPECT_EQ(system(), before);
    dialogs.expectNamed("rulesGoBox",
                        [](QDialog* box) { qobject_cast<QMessageBox*>(box)->defaultButton()->click(); });
    QTest::keyClick(terms(), Qt::Key_Delete);
    EXPECT_EQ(consistency().terms.size(), 6U);
    EXPECT_EQ(system().rules.size(), 6U);
    EXPECT_TRUE(dialogs.isDone());
    undo();
    EXPECT_EQ(system(), before);
}

TEST_F(DomainsPanelTest, TermsAreAddedMovedAndSpread) {
    const FuzzySystem before = system();
    const auto add = [this] {
        for (auto* button : panel()->findChildren<QToolButton*>())
            if (button->text() == "+ add") button->click();
    };
    add();
    ASSERT_EQ(consistency().terms.size(), 8U);
    const int row = terms()->currentRow();
    EXPECT_EQ(terms()->item(row)->text(), "new");
    QTest::keyClick(terms()->findChild<QLineEdit*>(), Qt::Key_Escape);
    button("Even partition")->click();
    EXPECT_DOUBLE_EQ(consistency().terms[1].set.a, 12.0 / 15);
    button("Overlap by half")->click();
    EXPECT_TRUE(message().isEmpty());
    const int steps = edits();
    for (auto* button : panel()->findChildren<QToolButton*>())
        if (button->toolTip().startsWith("Move the term up")) button->click();
    EXPECT_EQ(consistency().terms[static_cast<std::size_t>(row) - 1].name, "new");
    EXPECT_EQ(terms()->currentRow(), row - 1);
    EXPECT_EQ(edits(), steps + 1);
    QTest::keyClick(terms(), Qt::Key_Down, Qt::ControlModifier);
    EXPECT_EQ(consistency().terms[static_cast<std::size_t>(row)].name, "new");
    EXPECT_EQ(terms()->currentRow(), row);
    emit terms()->moveRequested(row, 0); // as a drop does
    EXPECT_EQ(consistency().terms[0].name, "new");
    EXPECT_EQ(terms()->currentRow(), 0);
    while (edits() > 2) // the region and its system
        undo();
    EXPECT_EQ(system(), before);
}

TEST_F(DomainsPanelTest, RangeAndUnitAreTyped) {
    const auto fields = child<QWidget>("range")->findChildren<NumberField*>();
    const double value = project().regions.back().inputs[0].second;
    typeInto(fields[1], "24");
    QTest::keyClick(fields[1], Qt::Key_Return);
    EXPECT_EQ(consistency().maximum, 24);
    EXPECT_EQ(consistency().terms.back().set.d, 24) << "the shoulder goes with the end";
    typeInto(fields[1], "5");
    QTest::keyClick(fields[1], Qt::Key_Return);
    EXPECT_TRUE(message().contains("would lie outside")) << message().toStdString();
    EXPECT_EQ(fields[1]->value(), 24.0);
    child<QCheckBox>("termsStretch")->setChecked(true);
    typeInto(fields[1], "240");
    QTest::keyClick(fields[1], Qt::Key_Return);
    EXPECT_EQ(consistency().terms[1].set.a, 25);
    EXPECT_DOUBLE_EQ(project().regions.back().inputs[0].second, 10 * value) << "it stays the same word";
    auto* unit = child<QLineEdit>("variableUnit");
    unit->setFocus();
    QTest::keyClicks(unit, "kPa");
    QTest::keyClick(unit, Qt::Key_Return);
    EXPECT_EQ(consistency().unit, "kPa");
    EXPECT_TRUE(child<QLabel>("domainWords")->text().contains("kPa"));
    typeInto(fields[1], "250 kPa");
    QTest::keyClick(fields[1], Qt::Key_Return);
    EXPECT_EQ(consistency().maximum, 250);
    EXPECT_TRUE(fields[1]->toolTip().endsWith(", in kPa"));
    EXPECT_TRUE(corner(Corner::A)->toolTip().endsWith(", in kPa"));
}

TEST_F(DomainsPanelTest, VariablesAreAddedRenamedAndRemoved) {
    const FuzzySystem before = system();
    const int steps = edits();
    dialogs.expect([](QWidget*) { return true; }, [](QDialog* dialog) { dialog->reject(); });
    trigger("Add input");
    EXPECT_EQ(edits(), steps) << "nothing is added that has no name";
    dialogs.expect([](QWidget*) { return true; },
                   [](QDialog* dialog) {
                       EXPECT_EQ(dialog->windowTitle(), "Add input");
                       dialog->findChild<QLineEdit*>()->setText("wetness");
                       dialog->accept();
                   });
    trigger("Add input");
    EXPECT_EQ(edits(), steps + 1);
    ASSERT_EQ(system().inputs.size(), 2U);
    EXPECT_EQ(system().inputs[1].name, "wetness");
    EXPECT_EQ(child<QComboBox>("variableChoice")->currentText(), "wetness");
    EXPECT_EQ(project().regions.back().inputs[1].first, "wetness");
    trigger("Move up");
    EXPECT_EQ(system().inputs[0].name, "wetness");
    EXPECT_EQ(ruleText(system(), system().rules[0]), ruleText(before, before.rules[0]));
    trigger("Remove");
    EXPECT_EQ(system().inputs, before.inputs);
    while (edits() > 2) // the region and its system
        undo();
    EXPECT_EQ(system(), before);
}

TEST_F(DomainsPanelTest, AnExpertStartsASystemOfHisOwn) {
    auto* choice = child<QComboBox>("systemChoice");
    const auto choose = [&](const QString& entry, const QString& name) {
        dialogs.expect([](QWidget*) { return true; },
                       [name](QDialog* dialog) {
                           dialog->findChild<QLineEdit*>()->setText(name);
                           dialog->accept();
                       });
        choice->setCurrentIndex(choice->findText(entry));
        emit choice->activated(choice->currentIndex());
    };
    window->document().edit("value", [](Project& p) { setInput(p.regions.back(), "consistency", 7); });
    choose("Copy under another name…", "mine");
    EXPECT_EQ(system().name, "mine");
    EXPECT_EQ(system().inputs, fuzzyPreset("susilap-g").inputs);
    EXPECT_EQ(project().regions.back().inputs[0].second, 7) << "a copy says the same";
    dialogs.expect([](QWidget*) { return true; },
                   [](QDialog* dialog) {
                       dialog->findChild<QLineEdit*>()->setText("own");
                       dialog->accept();
                   });
    choice->setCurrentIndex(choice->findText("New system…"));
    emit choice->activated(choice->currentIndex());
    dialogs.expect([](QWidget*) { return true; },
                   [](QDialog* dialog) {
                       EXPECT_EQ(dialog->findChild<QLineEdit*>()->text(), "own 2") << "a name that is free";
                       dialog->reject();
                   });
    choice->setCurrentIndex(choice->findText("New system…"));
    emit choice->activated(choice->currentIndex());
    choose("New system…", "bare");
    EXPECT_EQ(system().name, "bare");
    EXPECT_TRUE(system().rules.empty());
    EXPECT_TRUE(validate(project()).empty());
    addPublishedRegion();
    EXPECT_GE(choice->findText("bare", Qt::MatchStartsWith), 0) << "other regions can speak it too";
}

TEST_F(DomainsPanelTest, TheSectionKeepsItsHeight) {
    const int height = settledHeight(panel());
    auto* variables = child<QComboBox>("variableChoice");
    for (int row = 0; row < variables->count(); ++row) {
        variables->setCurrentIndex(row);
        emit variables->activated(row);
        QTest::qWait(0);
        EXPECT_EQ(panel()->height(), height) << row;
    }
}

TEST_F(DomainsPanelTest, KeysAloneShapeATerm) {
    EXPECT_EQ(partition()->term(), 4U) << "wobbly, which the value belongs to most";
    partition()->setFocus(Qt::TabFocusReason);
    for (int i = 0; i < 3; ++i)
        press(Qt::Key_Up);
    press(Qt::Key_Tab);
    press(Qt::Key_Tab);
    press(Qt::Key_Tab);
    const int steps = edits();
    press(Qt::Key_Right);
    press(Qt::Key_Right);
    EXPECT_DOUBLE_EQ(consistency().terms[1].set.d, 4.2);
    EXPECT_EQ(edits(), steps + 1);
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(consistency().terms[1].set.d, 4);
}

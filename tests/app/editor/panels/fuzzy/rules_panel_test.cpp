#include "app/editor/panels/fuzzy/rules_panel.h"

#include "app/editor/edits/selected_system.h"
#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/fuzzy/system_edits.h"
#include "core/samples/samples.h"
#include "tests/app/editor_driver.h"

#include <QAbstractItemView>
#include <QClipboard>
#include <QComboBox>

using namespace esm;

namespace {

constexpr const char* eighth = "IF consistency IS NOT soft THEN viscosity IS small WITH 0.1";

/// A region with the preset's seven rules, and the rules in hand.
class RulesPanelTest : public EditorTest {
protected:
    void SetUp() override {
        open(makeSample("tube"));
        addPublishedRegion();
        meanEveryRegion();
        chooseTab("Rules");
        panel = window->findChild<RulesPanel*>();
        ASSERT_TRUE(panel);
        panel->setPause(std::chrono::hours(1));
        edit = panel->text();
        original = edit->toPlainText();
        edit->setFocus();
    }
    const FuzzySystem& system() const { return *project().regions.back().system; }
    QString inForce() const { return QString::fromStdString(rulesText(system())); }
    Selection& selection() const { return *window->findChild<Selection*>(); }
    QString state() const { return child<QLabel>("ruleState")->text(); }
    int steps() const { return window->document().undoStack()->index(); }
    QStringList notes() const {
        QStringList texts;
        auto* list = child<QListWidget>("ruleNotes");
        for (int row = 0; row < list->count(); ++row)
            texts << list->item(row)->text();
        return texts;
    }
    void type(const QString& text) { QTest::keyClicks(edit, text); }
    void undo() { QTest::keyClick(edit, Qt::Key_Z, Qt::ControlModifier); }
    void redo() { QTest::keyClick(edit, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    void toEnd() { QTest::keyClick(edit, Qt::Key_End, Qt::ControlModifier); }
    QAbstractButton* button(const QString& text) const {
        for (auto* button : panel->findChildren<QAbstractButton*>())
            if (button->text() == text) return button;
        return nullptr;
    }
    /// Writes what cannot be in force.
    QString writeDraft() {
        toEnd();
        type(" AND");
        closeWords();
        return edit->toPlainText();
    }
    bool isAskedAbout() const { return !window->document().unfinished().isEmpty(); }
    /// The list of words takes a key while it is there.
    void closeWords() {
        QWidget* words = edit->completer()->popup();
        if (words->isVisible()) QTest::keyClick(words, Qt::Key_Escape);
    }

    RulesPanel* panel = nullptr;
    RuleTextEdit* edit = nullptr;
    QString original;
};

} // namespace

TEST_F(RulesPanelTest, ARuleIsTypedWithAMistakeMendedAndUndone) {
    EXPECT_EQ(original, inForce());
    const int before = steps();
    toEnd();
    QTest::keyClick(edit, Qt::Key_Return);
    type("IF consistency IS NOT softt ");
    type("THEN viscosity IS small");
    EXPECT_EQ(inForce(), original) << "what cannot be read is not in force";
    EXPECT_TRUE(state().contains("Not in force: rule 8, column 23: expected")) << state().toStdString();
    EXPECT_TRUE(state().contains("7 rules before still hold"));
    EXPECT_TRUE(notes().front().contains("expected the name of a term of consistency"));
    ASSERT_EQ(edit->extraSelections().size(), 1);
    EXPECT_EQ(edit->extraSelections()[0].cursor.selectedText(), "softt");
    emit child<QListWidget>("ruleNotes")->itemActivated(child<QListWidget>("ruleNotes")->item(0));
    EXPECT_TRUE(edit->hasFocus());
    for (int i = 0; i < 4; ++i)
        QTest::keyClick(edit, Qt::Key_Right);
    QTest::keyClick(edit, Qt::Key_Delete);
    EXPECT_EQ(system().rules.size(), 8u);
    EXPECT_TRUE(state().contains("In force: 8 rules"));
    EXPECT_EQ(steps(), before + 1);
    while (edit->toPlainText() != original && steps() > before - 1)
        undo();
    EXPECT_EQ(inForce(), original);
    EXPECT_EQ(steps(), before) << "the edit is gone with what was typed";
    undo();
    EXPECT_EQ(steps(), before - 1) << "then the edit before is taken back";
}

TEST_F(RulesPanelTest, ARunOfTypingIsOneEdit) {
    const int before = steps();
    toEnd();
    type(" WITH 0.25");
    closeWords();
    EXPECT_EQ(steps(), before + 1);
    EXPECT_DOUBLE_EQ(system().rules.back().weight, 0.25);
    child<QWidget>("regionList")->setFocus();
    edit->setFocus();
    type("5");
    EXPECT_DOUBLE_EQ(system().rules.back().weight, 0.255);
    EXPECT_EQ(steps(), before + 2) << "the text was left";
    edit->clearFocus();
    edit->setFocus();
    undo();
    EXPECT_DOUBLE_EQ(system().rules.back().weight, 0.25);
    EXPECT_TRUE(edit->toPlainText().endsWith("0.25")) << "the text follows";
    undo();
    EXPECT_EQ(edit->toPlainText(), original);
    redo();
    redo();
    EXPECT_DOUBLE_EQ(system().rules.back().weight, 0.255);
}

TEST_F(RulesPanelTest, ATermIsCompleted) {
    toEnd();
    QTest::keyClick(edit, Qt::Key_Return);
    type("IF consistency IS pud");
    QWidget* words = edit->completer()->popup();
    ASSERT_TRUE(words->isVisible());
    QTest::keyClick(words, Qt::Key_Return);
    EXPECT_TRUE(edit->toPlainText().endsWith("IF consistency IS pudding "));
}

TEST_F(RulesPanelTest, TextAndTableStayInStep) {
    button("Table")->click();
    RuleTableModel* cells = panel->table()->model();
    EXPECT_EQ(cells->rowCount(), 7);
    const int before = steps();
    panel->table()->goTo(0);
    QTest::keyClick(panel->table()->view(), Qt::Key_Return);
    auto* choice = panel->table()->view()->findChild<QComboBox*>();
    ASSERT_TRUE(choice);
    choice->setCurrentIndex(choice->findText("soft"));
    emit choice->activated(choice->currentIndex());
    EXPECT_TRUE(inForce().startsWith("IF consistency IS soft THEN"));
    EXPECT_EQ(edit->toPlainText(), inForce());
    EXPECT_EQ(steps(), before + 1);
    button("Text")->click();
    edit->goTo(0, 1);
    edit->editText(
        edit->toPlainText().replace("IF consistency IS soft THEN", "IF consistency IS NOT soft THEN"));
    button("Table")->click();
    EXPECT_EQ(cells->index(0, 0).data().toString(), "not soft");
    QTest::keyClick(panel->table()->view(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cells->index(0, 0).data().toString(), "soft");
    QTest::keyClick(panel->table()->view(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(inForce(), original);
    EXPECT_EQ(cells->index(0, 0).data().toString(), "flexible");
}

TEST_F(RulesPanelTest, ARowIsInForceOnceItIsFinished) {
    button("Table")->click();
    RuleTable* table = panel->table();
    const int before = steps();
    table->goTo(6);
    button("Add rule")->click();
    EXPECT_EQ(table->model()->rowCount(), 8);
    EXPECT_EQ(system().rules.size(), 7u);
    EXPECT_EQ(table->view()->currentIndex().row(), 7);
    table->model()->setData(table->model()->index(7, 0), 1, Qt::EditRole);
    EXPECT_EQ(system().rules.size(), 7u);
    table->model()->setData(table->model()->index(7, 2), 2, Qt::EditRole);
    EXPECT_EQ(system().rules.size(), 8u);
    EXPECT_EQ(steps(), before + 1);
    QTest::keyClick(table->view(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(edit->toPlainText(), original);
}

TEST_F(RulesPanelTest, WhatIsNotInForceWaitsWhileAnotherRegionIsSelected) {
    toEnd();
    type(" AND");
    closeWords();
    const QString draft = edit->toPlainText();
    selection().setRegion(std::nullopt);
    EXPECT_EQ(inForce(), original);
    selection().setRegion(project().regions.back().id);
    EXPECT_EQ(edit->toPlainText(), draft);
    EXPECT_TRUE(state().contains("Not in force"));
    button("Put back")->click();
    EXPECT_EQ(edit->toPlainText(), original);
    EXPECT_FALSE(button("Put back")->isEnabled());
    undo();
    EXPECT_EQ(edit->toPlainText(), draft) << "putting back is taken back as typing is";
}

TEST_F(RulesPanelTest, WhatIsNotInForceWaitsBesideARegionThatReadsAlike) {
    FuzzySystem alike = system();
    alike.note = "another's";
    addPublishedRegion();
    window->document().edit("alike", [&](Project& p) {
        setSystem(p, p.regions.back().id, std::make_shared<const FuzzySystem>(alike));
    });
    EXPECT_EQ(edit->toPlainText(), original);
    toEnd();
    type(" AND");
    closeWords();
    const QString draft = edit->toPlainText();
    const std::size_t last = project().regions.size() - 1;
    selection().setRegion(project().regions[last - 1].id);
    EXPECT_EQ(edit->toPlainText(), original);
    selection().setRegion(project().regions[last].id);
    EXPECT_EQ(edit->toPlainText(), draft);
}

TEST_F(RulesPanelTest, WhatIsNotInForceIsNotLostWithTheWindowUnasked) {
    window->document().markSaved("/nowhere/tube.esm", project());
    toEnd();
    type(" AND");
    closeWords();
    EXPECT_FALSE(window->document().isModified());
    dialogs.expectButton("unfinishedBox", QMessageBox::Cancel);
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(dialogs.isDone());
    window->document().replace(makeSample("liver"), std::nullopt);
    EXPECT_TRUE(window->close());
}

TEST_F(RulesPanelTest, WhatIsNotInForceDoesNotGoOverToAnotherSystem) {
    window->document().edit("alone", [](Project& p) { p.regions.erase(p.regions.begin()); });
    addPublishedRegion();
    FuzzySystem shorter = system();
    shorter.rules.pop_back();
    window->document().edit("other", [&](Project& p) {
        setSystem(p, p.regions.back().id, std::make_shared<const FuzzySystem>(shorter));
    });
    selection().setRegion(project().regions.rbegin()[1].id);
    const QString draft = writeDraft();
    window->document().edit("remove", [&](Project& p) { removeRegion(p, p.regions.rbegin()[1].id); });
    EXPECT_EQ(system(), shorter);
    EXPECT_EQ(edit->toPlainText(), inForce()) << "the region that follows has a system of its own";
    EXPECT_FALSE(isAskedAbout()) << "what no region has is not missed";
    window->document().undoStack()->undo();
    EXPECT_EQ(edit->toPlainText(), draft) << "with its region it comes back";
    EXPECT_TRUE(isAskedAbout());
    window->document().edit("choose", [&](Project& p) {
        setSystem(p, *selection().region(), std::make_shared<const FuzzySystem>(shorter));
    });
    EXPECT_EQ(edit->toPlainText(), QString::fromStdString(rulesText(shorter)));
    window->document().undoStack()->undo();
    EXPECT_EQ(edit->toPlainText(), draft);
}

TEST_F(RulesPanelTest, WhatIsNotInForceGoesWithItsSystemWhereAnotherRegionSpeaksIt) {
    addPublishedRegion();
    const std::size_t last = project().regions.size() - 1;
    ASSERT_NE(project().regions[last].system.get(), project().regions[last - 1].system.get());
    selection().setRegion(project().regions[last - 1].id);
    const QString draft = writeDraft();
    selection().setRegion(project().regions[last].id);
    EXPECT_EQ(edit->toPlainText(), draft) << "both speak the same system";
    selection().setRegion(std::nullopt);
    const RegionId edited = project().regions[last].id;
    window->document().edit(
        "range",
        [&](Project& p) {
            setRange(p, edited, {FuzzySide::Inputs, 0}, {0, 24, TermsInRange::Stay});
        },
        {}, edited);
    EXPECT_TRUE(isAskedAbout());
    selection().setRegion(project().regions[last - 1].id);
    EXPECT_EQ(edit->toPlainText(), draft);
    window->document().undoStack()->undo();
    EXPECT_EQ(edit->toPlainText(), draft);
}

TEST_F(RulesPanelTest, WhatIsTakenBackCanBeMadeAgainAfterARest) {
    toEnd();
    type(" WITH 0.25");
    closeWords();
    panel->setPause(std::chrono::milliseconds(0));
    undo();
    EXPECT_EQ(inForce(), original);
    ESM_EVENTUALLY(!panel->isRunOpen());
    redo();
    EXPECT_DOUBLE_EQ(system().rules.back().weight, 0.25);
    window->document().undoStack()->undo();
    EXPECT_EQ(inForce(), original);
}

TEST_F(RulesPanelTest, FollowsEditsFromElsewhere) {
    const auto rename = [&](const std::string& name) {
        editSelectedSystem(window->document(), selection(),
                           withTermRenamed(system(), {FuzzySide::Inputs, 0}, 1, name), {"Rename"});
    };
    const QString former = QString::fromStdString(system().inputs[0].terms[1].name);
    rename("springy");
    EXPECT_TRUE(edit->toPlainText().contains("IF consistency IS springy"));
    toEnd();
    type(" AND");
    closeWords();
    const QString draft = edit->toPlainText();
    window->document().undoStack()->undo();
    EXPECT_EQ(edit->toPlainText(), QString(draft).replace("springy", former))
        << "text to be mended is not lost, nor do its words come to mean others";
    EXPECT_EQ(inForce(), original);
    EXPECT_TRUE(state().contains("Not in force: rule 7, column")) << state().toStdString();
    EXPECT_FALSE(state().contains("more")) << state().toStdString();
    window->document().edit("Other", [&](Project& p) {
        setSystem(p, p.regions.back().id, std::make_shared<const FuzzySystem>(fuzzyPreset("robo-sim")));
    });
    EXPECT_EQ(edit->toPlainText(), inForce()) << "rules about other words";
}

TEST_F(RulesPanelTest, TenThousandLinesAreRefusedInOneMessage) {
    QApplication::clipboard()->setText(QString("\n%1").arg(eighth).repeated(10000));
    toEnd();
    QTest::keyClick(edit, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(edit->toPlainText(), original);
    EXPECT_TRUE(notes().front().contains("were not pasted")) << notes().front().toStdString();
    QApplication::clipboard()->setText(QString("\n%1").arg(eighth));
    QTest::keyClick(edit, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(system().rules.size(), 8u);
    EXPECT_FALSE(notes().front().contains("were not pasted"));
}

TEST_F(RulesPanelTest, ListsWhatIsOddAndGoesThere) {
    ESM_EVENTUALLY(notes().contains("No rule says that spring_const is large."));
    toEnd();
    QTest::keyClick(edit, Qt::Key_Return);
    type("IF consistency IS soft THEN viscosity IS small");
    closeWords();
    auto* list = child<QListWidget>("ruleNotes");
    ESM_EVENTUALLY(notes().front().startsWith("Rules 6 and 8 contradict each other on the same condition"));
    emit list->itemClicked(list->item(0));
    EXPECT_EQ(edit->textCursor().blockNumber(), 5);
}

TEST_F(RulesPanelTest, LinksWarningsOnlyToTheRulesTheyAreAbout) {
    edit->editText("IF consistency IS soft THEN viscosity IS small\n" + original);
    auto* list = child<QListWidget>("ruleNotes");
    const auto contradiction = [&] { return list->findItems("Rules 1 and", Qt::MatchStartsWith).value(0); };
    ESM_EVENTUALLY(contradiction());
    edit->editText("\n\nIF consistency IS\n" + edit->toPlainText());
    edit->goTo(2, 1);
    emit list->itemClicked(contradiction());
    EXPECT_EQ(edit->textCursor().blockNumber(), 2) << "the rules in force are not these lines";
}

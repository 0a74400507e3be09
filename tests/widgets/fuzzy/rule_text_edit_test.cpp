#include "widgets/fuzzy/rule_text_edit.h"

#include "tests/core/fuzzy/age_and_zeal.h"
#include "tests/support/eventually.h"

#include <gmock/gmock.h>
#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

using namespace esm;
using testing::ElementsAre;

namespace {

class RuleTextEditTest : public testing::Test {
protected:
    void SetUp() override {
        edit.setSystem(ageAndZealSystem());
        edit.resize(300, 200);
        edit.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&edit, patience));
        QApplication::setActiveWindow(&edit);
        edit.setFocus();
    }
    QStringList offered() const {
        const auto* popup = edit.completer()->popup();
        QStringList words;
        if (popup->isVisible())
            for (int row = 0; row < popup->model()->rowCount(); ++row)
                words << popup->model()->index(row, 0).data().toString();
        return words;
    }
    /// As a keyboard does: the list of words takes the keys while it is there.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWidget* popup = edit.completer()->popup();
        QTest::keyClick(popup->isVisible() ? popup : &edit, key, modifiers);
    }
    void paste(const QString& text) {
        QApplication::clipboard()->setText(text);
        edit.paste();
    }

    RuleTextEdit edit;
    QSignalSpy edited{&edit, &RuleTextEdit::edited};
};

std::vector<RuleWordKind> kindsOf(const QString& rule) {
    std::vector<RuleWordKind> kinds;
    for (const RuleWordPlace& word : RuleVocabulary(ageAndZealSystem()).wordsOf(rule))
        kinds.push_back(word.kind);
    return kinds;
}

} // namespace

TEST(RuleVocabulary, TellsWhatEachWordIs) {
    using K = RuleWordKind;
    EXPECT_THAT(kindsOf("if (age IS NOT old)THEN mass IS small with 0.5"),
                ElementsAre(K::Keyword, K::Keyword, K::Variable, K::Keyword, K::Keyword, K::Term, K::Keyword,
                            K::Keyword, K::Variable, K::Keyword, K::Term, K::Keyword, K::Number));
    EXPECT_THAT(kindsOf("IF ages IS old THEN age IS much Old"),
                ElementsAre(K::Keyword, K::Unknown, K::Keyword, K::Unknown, K::Keyword, K::Variable,
                            K::Keyword, K::Unknown, K::Unknown))
        << "a term is one of the variable before it";
}

TEST(PlaceOfLetter, CountsLettersWhereQtCountsHalves) {
    const QString text = QString::fromUtf8("IF 𝛼ß IS x");
    EXPECT_EQ(placeOfLetter(text, 1), 0);
    EXPECT_EQ(placeOfLetter(text, 4), 3);
    EXPECT_EQ(placeOfLetter(text, 5), 5) << "alpha takes two";
    EXPECT_EQ(placeOfLetter(text, 99), text.size());
}

TEST_F(RuleTextEditTest, OffersTheWordsThatFitAndWritesTheOneChosen) {
    QTest::keyClicks(&edit, "if age is o");
    EXPECT_EQ(offered(), QStringList({"old"}));
    press(Qt::Key_Return);
    EXPECT_EQ(edit.toPlainText(), "if age is old ");
    press(Qt::Key_Space, Qt::ControlModifier);
    EXPECT_EQ(offered(), QStringList({"AND", "OR", "THEN"}));
    press(Qt::Key_Down);
    press(Qt::Key_Down);
    press(Qt::Key_Tab);
    EXPECT_EQ(edit.toPlainText(), "if age is old THEN ");
    EXPECT_TRUE(edit.hasFocus());
    QTest::keyClicks(&edit, "v");
    press(Qt::Key_Escape);
    EXPECT_TRUE(offered().isEmpty());
    EXPECT_EQ(edit.toPlainText(), "if age is old THEN v");
}

TEST_F(RuleTextEditTest, OffersNothingOnceTheWordIsWritten) {
    QTest::keyClicks(&edit, "IF age IS young");
    EXPECT_TRUE(offered().isEmpty());
    press(Qt::Key_Return);
    EXPECT_EQ(edit.blockCount(), 2);
    QTest::keyClicks(&edit, "IF agee IS ");
    press(Qt::Key_Space, Qt::ControlModifier);
    EXPECT_TRUE(offered().isEmpty()) << "the rule cannot be read so far";
}

TEST_F(RuleTextEditTest, AWordChosenReplacesTheWholeWord) {
    edit.showText("IF age IS yold THEN mass IS small");
    edit.goTo(0, 12);
    press(Qt::Key_Space, Qt::ControlModifier);
    EXPECT_EQ(offered(), QStringList({"young"}));
    press(Qt::Key_Return);
    EXPECT_EQ(edit.toPlainText(), "IF age IS young THEN mass IS small");
}

TEST_F(RuleTextEditTest, UnderlinesWhatCannotBeRead) {
    const QString text = QString::fromUtf8("IF age IS 𝛼 THEN mass IS small\n\nIF age IS old ");
    edit.showText(text);
    edit.showMistakes(readRules(ageAndZealSystem(), edit.lines()).unread);
    const auto marks = edit.extraSelections();
    ASSERT_EQ(marks.size(), 2);
    EXPECT_EQ(marks[0].cursor.selectedText(), QString::fromUtf8("𝛼"));
    EXPECT_EQ(marks[1].cursor.selectedText(), "d") << "the last letter, where the rule ends too early";
    EXPECT_EQ(marks[0].format.underlineStyle(), QTextCharFormat::WaveUnderline);
    edit.showMistakes({});
    EXPECT_TRUE(edit.extraSelections().isEmpty());
}

TEST_F(RuleTextEditTest, AnnouncesWhatTheUserChangesAlone) {
    edit.showText("IF age IS old THEN mass IS small");
    edit.setSystem(ageAndZealSystem());
    EXPECT_EQ(edited.count(), 0);
    EXPECT_FALSE(edit.undoText()) << "what is shown cannot be undone";
    edit.editText("IF age IS young THEN mass IS small");
    EXPECT_EQ(edited.count(), 1);
    EXPECT_TRUE(edit.undoText());
    EXPECT_EQ(edit.toPlainText(), "IF age IS old THEN mass IS small");
    EXPECT_TRUE(edit.redoText());
    EXPECT_EQ(edited.count(), 3);
}

TEST_F(RuleTextEditTest, AsksForUndoInsteadOfDoingIt) {
    QSignalSpy undo(&edit, &RuleTextEdit::undoRequested), redo(&edit, &RuleTextEdit::redoRequested);
    QTest::keyClicks(&edit, "IF");
    press(Qt::Key_Z, Qt::ControlModifier);
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    press(Qt::Key_Y, Qt::ControlModifier);
    EXPECT_EQ(undo.count(), 1);
    EXPECT_EQ(redo.count(), 2);
    EXPECT_EQ(edit.toPlainText(), "IF");
}

TEST_F(RuleTextEditTest, RefusesMoreLinesThanThereMayBeRules) {
    QSignalSpy refused(&edit, &RuleTextEdit::pasteRefused);
    edit.showText("IF age IS old THEN mass IS small");
    paste(QString("IF age IS old THEN mass IS small\n").repeated(10000));
    ASSERT_EQ(refused.count(), 1);
    EXPECT_TRUE(refused[0][0].toString().startsWith(QString::fromUtf8("10\u202f001 lines were not pasted")))
        << refused[0][0].toString().toStdString();
    paste(QString("IF age IS old AND ").repeated(100000));
    EXPECT_EQ(refused.count(), 2);
    EXPECT_EQ(edit.blockCount(), 1);
    paste("\nIF zeal IS much THEN mass IS small");
    EXPECT_EQ(edited.count(), 1);
}

TEST_F(RuleTextEditTest, WhatAPasteReplacesDoesNotCount) {
    QSignalSpy refused(&edit, &RuleTextEdit::pasteRefused);
    const QString many = QString("IF age IS old THEN mass IS small\n").repeated(1500);
    edit.showText(many);
    edit.selectAll();
    paste(many);
    EXPECT_EQ(refused.count(), 0);
    EXPECT_EQ(edit.blockCount(), 1501);
    paste(many);
    EXPECT_EQ(refused.count(), 1);
}

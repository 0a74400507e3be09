#pragma once

#include "core/fuzzy/rule_lines.h"
#include "widgets/fuzzy/rule_highlighter.h"

#include <QCompleter>
#include <QPlainTextEdit>
#include <QStringListModel>

#include <vector>

namespace esm {

/// Rules as text, one per line, numbered: words coloured by what they are, words that fit offered while one
/// is typed (all of them by Ctrl+Space), and what cannot be read underlined.
class RuleTextEdit : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit RuleTextEdit(QWidget* parent = nullptr);

    /// The variables and terms that rules may speak of; its own rules do not count.
    void setSystem(const FuzzySystem& system);
    /// Shows a text without announcing it. Nothing to undo remains.
    void showText(const QString& text);
    /// Puts another text in the place of what differs, as if it were typed.
    void editText(const QString& text);
    std::vector<std::string> lines() const;
    /// Underlines what cannot be read, and says why where the mouse points.
    void showMistakes(const std::vector<UnreadRule>& unread);
    /// Puts the cursor to a letter, counted from 1, of a line, counted from 0.
    void goTo(std::size_t line, std::size_t column);

    /// Takes the change that is being announced back, without announcing it.
    void takeBack();
    /// Takes a change of the text back, or makes it again; false where there is none.
    bool undoText();
    bool redoText();
    /// What was written cannot be taken back any more; what was taken back can still be made again.
    void forgetUndo() { document()->clearUndoRedoStacks(QTextDocument::UndoStack); }
    void forgetEdits() { document()->clearUndoRedoStacks(); }

    QCompleter* completer() const { return m_completer; }

    int gutterWidth() const;
    void paintGutter(QPaintEvent* event);

signals:
    /// The user changed the text.
    void edited();
    /// Ctrl+Z and its like, where the text may have nothing to undo.
    void undoRequested();
    void redoRequested();
    /// More was pasted than a system may have rules; it was not taken.
    void pasteRefused(const QString& why);
    /// The cursor left the text.
    void left();

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool canInsertFromMimeData(const QMimeData* source) const override;
    void insertFromMimeData(const QMimeData* source) override;

private:
    enum class Offer { WhileTyping, Everything };

    void takeChange();
    void layOutGutter();
    void offerWords(Offer offer);
    void complete(const QString& word);
    /// From the beginning of the word before the cursor up to the cursor.
    QTextCursor wordBegun() const;
    bool isOffering() const;
    const UnreadRule* mistakeAt(const QPoint& position) const;

    FuzzySystem m_system;
    RuleHighlighter* m_highlighter;
    QCompleter* m_completer;
    QStringListModel* m_words;
    QWidget* m_gutter;
    QString m_text;   ///< as it was announced last
    QString m_before; ///< the change that was announced last
    bool m_isQuiet = false;
    std::vector<UnreadRule> m_unread;
};

/// Where a letter, counted from 1, lies in a text, in a QString's units; its end where it is shorter.
int placeOfLetter(const QString& text, std::size_t column);

} // namespace esm

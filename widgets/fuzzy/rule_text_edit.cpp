#include "widgets/fuzzy/rule_text_edit.h"

#include "core/fuzzy/keywords.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/number_text.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr int gutterPadding = 6;            // pixels
constexpr int longestPaste = 1'000'000;     // letters
constexpr std::size_t mostUnderlined = 100; // more would only cost time

/// The numbers of the rules beside their lines.
class RuleGutter : public QWidget {
public:
    explicit RuleGutter(RuleTextEdit* edit) : QWidget(edit), m_edit(edit) {}

protected:
    void paintEvent(QPaintEvent* event) override { m_edit->paintGutter(event); }

private:
    RuleTextEdit* m_edit;
};

bool endsWord(QChar c) {
    return c <= ' ' || c == '(' || c == ')';
}

bool holdsNoWord(const QString& line) {
    return std::all_of(line.begin(), line.end(), [](QChar c) { return c <= ' '; });
}

} // namespace

int placeOfLetter(const QString& text, std::size_t column) {
    int place = 0;
    for (std::size_t letter = 1; letter < column && place < text.size(); ++letter)
        place += text[place].isHighSurrogate() && place + 1 < text.size() ? 2 : 1;
    return place;
}

RuleTextEdit::RuleTextEdit(QWidget* parent)
    : QPlainTextEdit(parent), m_highlighter(new RuleHighlighter(document())),
      m_completer(new QCompleter(this)), m_words(new QStringListModel(this)), m_gutter(new RuleGutter(this)) {
    setAccessibleName(tr("Rules"));
    setToolTip(tr("A rule a line. Ctrl+Space shows the words that fit"));
    setPlaceholderText(tr("IF … IS … THEN … IS …\nCtrl+Space shows the words that fit."));
    setTabChangesFocus(true);
    setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    m_highlighter->setPalette(palette());
    m_completer->setModel(m_words);
    m_completer->setWidget(this);
    m_completer->popup()->setObjectName(QStringLiteral("fittingWords"));
    m_completer->setCompletionMode(QCompleter::PopupCompletion);
    m_completer->setCaseSensitivity(Qt::CaseInsensitive);
    connect(m_completer, qOverload<const QString&>(&QCompleter::activated), this, &RuleTextEdit::complete);
    connect(this, &QPlainTextEdit::textChanged, this, &RuleTextEdit::takeChange);
    connect(this, &QPlainTextEdit::blockCountChanged, this, &RuleTextEdit::layOutGutter);
    connect(this, &QPlainTextEdit::updateRequest, m_gutter,
            [this](const QRect&, int) { m_gutter->update(); });
    layOutGutter();
}

void RuleTextEdit::setSystem(const FuzzySystem& system) {
    m_system = system;
    m_highlighter->setVocabulary(RuleVocabulary(system));
}

void RuleTextEdit::showText(const QString& text) {
    if (text == m_text) return;
    m_isQuiet = true;
    const QTextCursor before = textCursor();
    const int scrolled = verticalScrollBar()->value();
    const int line = before.blockNumber(), column = before.positionInBlock();
    setPlainText(text);
    m_text = text;
    m_isQuiet = false;
    QTextCursor cursor(document()->findBlockByNumber(std::min(line, blockCount() - 1)));
    cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::MoveAnchor,
                        std::min(column, cursor.block().length() - 1));
    setTextCursor(cursor);
    verticalScrollBar()->setValue(scrolled);
}

void RuleTextEdit::editText(const QString& text) {
    const QString before = toPlainText();
    const int most = std::min(before.size(), text.size());
    int start = 0, end = 0;
    while (start < most && before[start] == text[start])
        ++start;
    while (end < most - start && before[before.size() - 1 - end] == text[text.size() - 1 - end])
        ++end;
    QTextCursor cursor(document());
    cursor.setPosition(start);
    cursor.setPosition(before.size() - end, QTextCursor::KeepAnchor);
    cursor.insertText(text.mid(start, text.size() - start - end));
}

std::vector<std::string> RuleTextEdit::lines() const {
    std::vector<std::string> lines;
    lines.reserve(static_cast<std::size_t>(blockCount()));
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
        lines.push_back(block.text().toStdString());
    return lines;
}

void RuleTextEdit::showMistakes(const std::vector<UnreadRule>& unread) {
    m_unread = unread;
    QList<QTextEdit::ExtraSelection> underlined;
    for (std::size_t i = 0; i < std::min(unread.size(), mostUnderlined); ++i) {
        const RuleMistake& mistake = unread[i].mistake;
        const QTextBlock block = document()->findBlockByNumber(static_cast<int>(unread[i].line));
        const QString text = block.text();
        int start = placeOfLetter(text, mistake.column);
        int end = placeOfLetter(text, mistake.column + mistake.length);
        // Where the rule ends too early, its last letter stands for what is missing behind it.
        if (start == end) {
            end = text.size();
            while (end > 1 && text[end - 1] <= ' ')
                --end;
            start = std::max(0, end - 1);
        }
        QTextEdit::ExtraSelection selection;
        selection.cursor = QTextCursor(block);
        selection.cursor.setPosition(block.position() + start);
        selection.cursor.setPosition(block.position() + end, QTextCursor::KeepAnchor);
        selection.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        selection.format.setUnderlineColor(palette().color(QPalette::BrightText));
        underlined.push_back(selection);
    }
    setExtraSelections(underlined);
    m_gutter->update();
}

void RuleTextEdit::goTo(std::size_t line, std::size_t column) {
    const QTextBlock block = document()->findBlockByNumber(static_cast<int>(line));
    if (!block.isValid()) return;
    QTextCursor cursor(block);
    cursor.setPosition(block.position() + placeOfLetter(block.text(), column));
    setTextCursor(cursor);
    setFocus();
}

bool RuleTextEdit::undoText() {
    if (!document()->isUndoAvailable()) return false;
    undo();
    return true;
}

bool RuleTextEdit::redoText() {
    if (!document()->isRedoAvailable()) return false;
    redo();
    return true;
}

/// Colouring words counts as a change with Qt.
void RuleTextEdit::takeChange() {
    if (m_isQuiet) return;
    const QString text = toPlainText();
    if (text == m_text) return;
    m_before = std::exchange(m_text, text);
    emit edited();
}

void RuleTextEdit::takeBack() {
    showText(m_before);
}

bool RuleTextEdit::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || isRedo(*key)) {
            event->accept();
            return true;
        }
    }
    return QPlainTextEdit::event(event);
}

void RuleTextEdit::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Undo)) return emit undoRequested();
    if (isRedo(*event)) return emit redoRequested();
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier)
        return offerWords(Offer::Everything);
    if (isOffering()) {
        // The list of words takes these when they come back to it.
        for (const int key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_Escape})
            if (event->key() == key) return event->ignore();
    }
    const bool breaksLine = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (breaksLine && event->modifiers() == Qt::ShiftModifier) {
        // To Qt a line break within a paragraph, which rules have not.
        QKeyEvent plain(QEvent::KeyPress, event->key(), Qt::NoModifier, event->text());
        return QPlainTextEdit::keyPressEvent(&plain);
    }
    QPlainTextEdit::keyPressEvent(event);
    const bool isWriting = !event->text().isEmpty() && event->text()[0].isPrint();
    if (isWriting || (isOffering() && event->key() == Qt::Key_Backspace))
        offerWords(Offer::WhileTyping);
    else if (isOffering())
        m_completer->popup()->hide();
}

bool RuleTextEdit::focusNextPrevChild(bool next) {
    return !isOffering() && QPlainTextEdit::focusNextPrevChild(next);
}

bool RuleTextEdit::isOffering() const {
    return m_completer->popup()->isVisible();
}

QTextCursor RuleTextEdit::wordBegun() const {
    QTextCursor cursor = textCursor();
    const QString text = cursor.block().text();
    const int end = cursor.positionInBlock();
    int start = end;
    while (start > 0 && !endsWord(text[start - 1]))
        --start;
    cursor.setPosition(cursor.block().position() + start);
    cursor.setPosition(cursor.block().position() + end, QTextCursor::KeepAnchor);
    return cursor;
}

void RuleTextEdit::offerWords(Offer offer) {
    const QTextCursor begun = wordBegun();
    const QString word = begun.selectedText();
    const QString beginning = begun.block().text().left(begun.selectionStart() - begun.block().position());
    QStringList fitting;
    for (const std::string& fits : wordsThatFit(m_system, beginning.toStdString())) {
        const QString text = QString::fromStdString(fits);
        if (text.startsWith(word, Qt::CaseInsensitive)) fitting << text;
    }
    const bool isWritten = std::any_of(fitting.begin(), fitting.end(), [&](const QString& text) {
        return text.compare(word, Qt::CaseInsensitive) == 0;
    });
    if (fitting.isEmpty() || (offer == Offer::WhileTyping && (word.isEmpty() || isWritten)))
        return m_completer->popup()->hide();
    m_words->setStringList(fitting);
    m_completer->setCompletionPrefix(word);
    QAbstractItemView* popup = m_completer->popup();
    popup->setCurrentIndex(m_completer->completionModel()->index(0, 0));
    QRect place = cursorRect(begun);
    place.setWidth(popup->sizeHintForColumn(0) + popup->verticalScrollBar()->sizeHint().width() + 12);
    place.translate(viewport()->pos());
    m_completer->complete(place);
}

void RuleTextEdit::complete(const QString& word) {
    QTextCursor cursor = wordBegun();
    const QString text = cursor.block().text();
    int end = cursor.selectionEnd() - cursor.block().position();
    while (end < text.size() && !endsWord(text[end]))
        ++end;
    cursor.setPosition(cursor.block().position() + end, QTextCursor::KeepAnchor);
    const bool needsSpace = end == text.size() && !isBracket(word.front().toLatin1());
    cursor.insertText(needsSpace ? word + ' ' : word);
    setTextCursor(cursor);
}

/// A file that is dropped is the window's to open.
bool RuleTextEdit::canInsertFromMimeData(const QMimeData* source) const {
    return source->hasText() && !source->hasUrls();
}

void RuleTextEdit::insertFromMimeData(const QMimeData* source) {
    const QString text = source->text();
    const int lines = text.count('\n') + text.count(QChar::ParagraphSeparator);
    const int replaced = textCursor().selectedText().count(QChar::ParagraphSeparator);
    if (blockCount() - replaced + lines > static_cast<int>(mostFuzzyRules))
        return emit pasteRefused(
            tr("%1 lines were not pasted: a fuzzy system may have %2 rules.")
                .arg(countText(static_cast<std::size_t>(lines) + 1), countText(mostFuzzyRules)));
    if (text.size() > longestPaste)
        return emit pasteRefused(tr("Nothing was pasted: the text is too long to be rules."));
    QPlainTextEdit::insertFromMimeData(source);
}

void RuleTextEdit::focusOutEvent(QFocusEvent* event) {
    QPlainTextEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::MenuBarFocusReason) emit left();
}

const UnreadRule* RuleTextEdit::mistakeAt(const QPoint& position) const {
    const auto line = static_cast<std::size_t>(cursorForPosition(position).blockNumber());
    const auto found = std::find_if(m_unread.begin(), m_unread.end(),
                                    [&](const UnreadRule& rule) { return rule.line == line; });
    return found == m_unread.end() ? nullptr : &*found;
}

bool RuleTextEdit::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QPlainTextEdit::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const UnreadRule* mistake = mistakeAt(help->pos());
    QToolTip::showText(help->globalPos(), mistake ? QString::fromStdString(mistake->message) : toolTip(),
                       this);
    return true;
}

int RuleTextEdit::gutterWidth() const {
    const int digits = blockCount() < 100 ? 2 : blockCount() < 1000 ? 3 : 4;
    return 2 * gutterPadding + digits * fontMetrics().horizontalAdvance('8');
}

void RuleTextEdit::layOutGutter() {
    setViewportMargins(gutterWidth(), 0, 0, 0);
    const QRect inner = contentsRect();
    m_gutter->setGeometry(inner.left(), inner.top(), gutterWidth(), inner.height());
}

void RuleTextEdit::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    layOutGutter();
}

void RuleTextEdit::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
        m_highlighter->setPalette(palette());
        showMistakes(m_unread);
    }
    if (event->type() == QEvent::FontChange) layOutGutter();
}

/// A hairline between rules shows which lines belong together where they are wrapped.
void RuleTextEdit::paintEvent(QPaintEvent* event) {
    QPlainTextEdit::paintEvent(event);
    QPainter painter(viewport());
    QColor hairline = palette().color(QPalette::Mid);
    hairline.setAlpha(110);
    painter.setPen(hairline);
    for (QTextBlock block = firstVisibleBlock(); block.next().isValid(); block = block.next()) {
        const int bottom = qRound(blockBoundingGeometry(block).translated(contentOffset()).bottom());
        if (bottom > viewport()->height()) break;
        painter.drawLine(0, bottom, viewport()->width(), bottom);
    }
}

void RuleTextEdit::paintGutter(QPaintEvent* event) {
    QPainter painter(m_gutter);
    painter.fillRect(event->rect(), palette().color(QPalette::AlternateBase));
    int number = 0;
    for (QTextBlock block = document()->begin(); block != firstVisibleBlock(); block = block.next())
        number += !holdsNoWord(block.text());
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF place = blockBoundingGeometry(block).translated(contentOffset());
        if (place.top() > m_gutter->height()) break;
        if (holdsNoWord(block.text())) continue;
        ++number;
        const auto line = static_cast<std::size_t>(block.blockNumber());
        const bool isUnread = std::any_of(m_unread.begin(), m_unread.end(),
                                          [&](const UnreadRule& rule) { return rule.line == line; });
        painter.setPen(palette().color(isUnread ? QPalette::BrightText : QPalette::PlaceholderText));
        painter.drawText(QRectF(0, place.top(), m_gutter->width() - gutterPadding, fontMetrics().height()),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(number));
    }
}

} // namespace esm

#include "widgets/fuzzy/rule_notes.h"

#include <QEvent>
#include <QStyledItemDelegate>

namespace esm {

namespace {

constexpr QSize noteFrame(10, 6); // pixels around the text, as in the style sheet
constexpr int longestNote = 600;  // letters: a word that is not known may be as long as one likes

/// As high as the text is in the list's width.
class NoteDelegate : public QStyledItemDelegate {
public:
    explicit NoteDelegate(QListWidget* list) : QStyledItemDelegate(list), m_list(list) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int width = m_list->viewport()->width();
        // Styles keep a margin beside the text.
        const QRect room(0, 0, width - noteFrame.width() - 10, 10000);
        const int height =
            option.fontMetrics.boundingRect(room, Qt::TextWordWrap, index.data().toString()).height();
        return {width, height + noteFrame.height() + 2};
    }

private:
    QListWidget* m_list;
};

QPalette::ColorRole roleOf(RuleNote::Kind kind) {
    switch (kind) {
    case RuleNote::Kind::Mistake:
        return QPalette::BrightText;
    case RuleNote::Kind::Warning:
        return QPalette::LinkVisited;
    default:
        return QPalette::PlaceholderText;
    }
}

} // namespace

RuleNotes::RuleNotes(QWidget* parent) : QListWidget(parent) {
    setObjectName(QStringLiteral("ruleNotes"));
    setAccessibleName(tr("Notes about the rules"));
    setToolTip(tr("What is wrong or worth a look in the rules; Enter or a click goes there"));
    setItemDelegate(new NoteDelegate(this));
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setResizeMode(QListView::Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(this, &QListWidget::itemClicked, this, &RuleNotes::pick);
    connect(this, &QListWidget::itemActivated, this, &RuleNotes::pick);
}

void RuleNotes::setNotes(const std::vector<RuleNote>& notes) {
    m_notes = notes;
    showNotes();
}

void RuleNotes::showNotes() {
    clear();
    for (const RuleNote& note : m_notes) {
        const bool isLong = note.text.size() > longestNote;
        auto* item =
            new QListWidgetItem(isLong ? note.text.left(longestNote) + QChar(0x2026) : note.text, this);
        item->setForeground(palette().color(QPalette::Active, roleOf(note.kind)));
        item->setToolTip(note.line < 0 ? item->text() : tr("%1\nA click goes there.").arg(item->text()));
        if (note.kind == RuleNote::Kind::Quiet) item->setFlags(Qt::ItemIsEnabled);
    }
}

void RuleNotes::pick(const QListWidgetItem* item) {
    const RuleNote& note = m_notes[static_cast<std::size_t>(row(item))];
    if (note.line >= 0) emit placePicked(note.line, note.column);
}

void RuleNotes::changeEvent(QEvent* event) {
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showNotes(); // in the colours of the theme
}

} // namespace esm

#include "widgets/fuzzy/term_scale.h"

#include "core/fuzzy/inference.h"
#include "widgets/fuzzy/small_font.h"
#include "widgets/fuzzy/term_layout.h"
#include "widgets/inputs/number_text.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int smallestGap = 6, tickHeight = 4, tickRoom = 5; // pixels
/// How far a word may stand from its place before a second row is opened, pixels.
constexpr double tolerableShift = 10;

double coreMiddle(const FuzzyTerm& term) {
    return (term.set.b + term.set.c) / 2;
}

} // namespace

QString readableName(const std::string& name) {
    return QString::fromStdString(name).replace('_', ' ');
}

QString wordsFor(const FuzzyVariable& variable, double value) {
    const std::string words = inWords(variable, value);
    if (words != "none") return readableName(words);
    const auto isAbove = [&](const FuzzyTerm& term) { return value > term.set.d; };
    const auto isBelow = [&](const FuzzyTerm& term) { return value < term.set.a; };
    const auto& terms = variable.terms;
    if (std::all_of(terms.begin(), terms.end(), isAbove)) return QObject::tr("above all words");
    if (std::all_of(terms.begin(), terms.end(), isBelow)) return QObject::tr("below all words");
    return QObject::tr("between the words");
}

TermScale::TermScale(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setFont(smallFont(font()));
    setToolTip(tr("Click a word to go to where it holds fully"));
}

void TermScale::setVariable(const FuzzyVariable& variable) {
    m_variable = variable;
    layOut();
}

void TermScale::setValue(std::optional<double> value) {
    m_value = value;
    tellSpoken(*this);
    update();
}

QString TermScale::spokenValue() const {
    if (!m_note.isEmpty()) return m_note;
    return m_value ? wordsFor(m_variable, *m_value) : tr("no value");
}

void TermScale::setNote(const QString& note) {
    m_note = note;
    update();
}

void TermScale::setInset(int pixels) {
    if (pixels == m_inset) return;
    m_inset = pixels;
    layOut();
}

QSize TermScale::sizeHint() const {
    return {100, tickRoom + m_rows * fontMetrics().height() + 1};
}

void TermScale::resizeEvent(QResizeEvent*) {
    layOut();
}

double TermScale::wordWidth(std::size_t term) const {
    return fontMetrics().horizontalAdvance(readableName(m_variable.terms[term].name)) + 2;
}

/// A second row is opened only where words stand too far from their places in one, as height is dear in a
/// column of sliders.
void TermScale::layOut() {
    const auto shift = [](const Place& place) {
        return std::abs(place.rect.x() + place.rect.width() / 2.0 - place.tick);
    };
    m_rows = 1;
    m_places = inRows(1);
    // At the ends a word cannot stand in the middle of its place.
    const bool isCrowded = std::any_of(m_places.begin(), m_places.end(), [&](const Place& place) {
        const double atEnd = place.rect.width() / 2.0 - std::min(place.tick, width() - place.tick);
        return shift(place) > std::max(0.0, atEnd) + tolerableShift ||
               place.rect.width() < std::floor(wordWidth(place.term));
    });
    if (isCrowded) {
        m_rows = 2;
        m_places = inRows(2);
    }
    updateGeometry();
    update();
}

/// Neighbours go to rows in turn: those of one row then have twice the room.
std::vector<TermScale::Place> TermScale::inRows(int rows) const {
    std::vector<Place> places;
    const double room = width() - 2 * m_inset, range = m_variable.maximum - m_variable.minimum;
    for (std::size_t i = 0; i < m_variable.terms.size(); ++i) {
        const double share = (coreMiddle(m_variable.terms[i]) - m_variable.minimum) / range;
        places.push_back({i, m_inset + std::clamp(share, 0.0, 1.0) * room, {}});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.tick < b.tick; });
    for (int row = 0; row < rows; ++row) {
        std::vector<Place*> members;
        for (std::size_t i = static_cast<std::size_t>(row); i < places.size();
             i += static_cast<std::size_t>(rows))
            members.push_back(&places[i]);
        placeRow(members, tickRoom + row * fontMetrics().height());
    }
    return places;
}

void TermScale::placeRow(std::vector<Place*>& row, int top) const {
    double total = 0;
    for (const Place* place : row)
        total += wordWidth(place->term);
    const double room = width() - smallestGap * (static_cast<double>(row.size()) - 1);
    const double shrink = total > room ? std::max(0.0, room) / total : 1;
    std::vector<PlacedWord> words;
    words.reserve(row.size());
    for (const Place* place : row)
        words.push_back({place->tick, shrink * wordWidth(place->term)});
    const std::vector<double> lefts = spreadWords(words, width(), smallestGap);
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i]->rect = QRect(qRound(lefts[i]), top, static_cast<int>(words[i].width), fontMetrics().height());
}

QColor TermScale::colourOf(const FuzzyTerm& term) const {
    if (m_value && membership(term.set, *m_value) > 0) return palette().color(QPalette::Link);
    return palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::PlaceholderText);
}

void TermScale::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!m_note.isEmpty()) {
        painter.setPen(palette().color(QPalette::LinkVisited));
        painter.drawText(rect().adjusted(0, tickRoom, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                         fontMetrics().elidedText(m_note, Qt::ElideRight, width()));
        return;
    }
    for (const Place& place : m_places) {
        const FuzzyTerm& term = m_variable.terms[place.term];
        painter.setPen(colourOf(term));
        painter.drawLine(QPointF(place.tick, 0), QPointF(place.tick, tickHeight - 1));
        const QString name =
            fontMetrics().elidedText(readableName(term.name), Qt::ElideRight, place.rect.width());
        painter.drawText(place.rect, Qt::AlignHCenter | Qt::AlignVCenter, name);
    }
}

int TermScale::termAt(const QPoint& position) const {
    if (!m_note.isEmpty()) return -1;
    for (const Place& place : m_places)
        if (place.rect.contains(position)) return static_cast<int>(place.term);
    return -1;
}

void TermScale::mousePressEvent(QMouseEvent* event) {
    if (!isEnabled()) return;
    const int index = termAt(event->pos());
    if (index < 0) return;
    emit termPicked(coreMiddle(m_variable.terms[static_cast<std::size_t>(index)]));
}

QString TermScale::explained(const FuzzyTerm& term) const {
    const Trapezoid& set = term.set;
    const QString core = set.b == set.c ? tr("fully at %1").arg(numberText(set.b))
                                        : tr("fully from %1 to %2").arg(numberText(set.b), numberText(set.c));
    return tr("%1: %2, partly from %3 to %4. A click goes there.")
        .arg(readableName(term.name), core, numberText(set.a), numberText(set.d));
}

bool TermScale::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int index = termAt(help->pos());
    QString said = m_note.isEmpty() ? toolTip() : m_note;
    if (index >= 0 && isEnabled()) said = explained(m_variable.terms[static_cast<std::size_t>(index)]);
    QToolTip::showText(help->globalPos(), said, this);
    return true;
}

} // namespace esm

#include "widgets/fuzzy/term_scale.h"

#include "widgets/inputs/number_text.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <numeric>

namespace esm {

namespace {

constexpr int smallestGap = 5;

} // namespace

QString readableName(const std::string& name) {
    return QString::fromStdString(name).replace('_', ' ');
}

TermScale::TermScale(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.84);
    setFont(small);
}

void TermScale::setVariable(const FuzzyVariable& variable) {
    m_variable = variable;
    update();
}

void TermScale::setValue(std::optional<double> value) {
    m_value = value;
    update();
}

void TermScale::setNote(const QString& note) {
    m_note = note;
    update();
}

QSize TermScale::sizeHint() const {
    return {100, fontMetrics().height() + 2};
}

QFont TermScale::fittingFont() const {
    const int gaps = smallestGap * qMax(0, static_cast<int>(m_variable.terms.size()) - 1);
    int total = 0;
    for (const auto& term : m_variable.terms)
        total += fontMetrics().horizontalAdvance(readableName(term.name)) + 2;
    QFont fitting = font();
    if (total > width() - gaps)
        fitting.setPointSizeF(fitting.pointSizeF() * qMax(0.75, double(width() - gaps) / total));
    return fitting;
}

std::vector<QRect> TermScale::termRects() const {
    const QFontMetrics metrics(fittingFont());
    std::vector<int> widths;
    for (const auto& term : m_variable.terms)
        widths.push_back(metrics.horizontalAdvance(readableName(term.name)) + 2);
    const int total = std::accumulate(widths.begin(), widths.end(), 0);
    const int count = static_cast<int>(widths.size());
    const int room = width() - smallestGap * qMax(0, count - 1);
    const double shrink = total > room ? double(room) / total : 1;
    const double gap = count > 1 ? (width() - total * shrink) / (count - 1) : 0;
    std::vector<QRect> rects;
    double x = 0;
    for (const int termWidth : widths) {
        rects.emplace_back(qRound(x), 0, qRound(termWidth * shrink), height());
        x += termWidth * shrink + gap;
    }
    return rects;
}

void TermScale::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QColor quiet =
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::PlaceholderText);
    if (!m_note.isEmpty()) {
        painter.setPen(palette().color(QPalette::LinkVisited));
        painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(m_note, Qt::ElideRight, width()));
        return;
    }
    const auto rects = termRects();
    painter.setFont(fittingFont());
    for (std::size_t i = 0; i < rects.size(); ++i) {
        const auto& term = m_variable.terms[i];
        const bool active = m_value && membership(term.set, *m_value) > 0;
        painter.setPen(active ? palette().color(QPalette::Link) : quiet);
        const QString name =
            painter.fontMetrics().elidedText(readableName(term.name), Qt::ElideRight, rects[i].width());
        painter.drawText(rects[i], Qt::AlignLeft | Qt::AlignVCenter, name);
    }
}

int TermScale::termAt(const QPoint& position) const {
    if (!m_note.isEmpty()) return -1;
    const auto rects = termRects();
    for (std::size_t i = 0; i < rects.size(); ++i)
        if (rects[i].contains(position)) return static_cast<int>(i);
    return -1;
}

void TermScale::mousePressEvent(QMouseEvent* event) {
    const int index = termAt(event->pos());
    if (index < 0) return;
    const Trapezoid& set = m_variable.terms[static_cast<std::size_t>(index)].set;
    emit termPicked((set.b + set.c) / 2);
}

bool TermScale::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int index = termAt(help->pos());
    if (!m_note.isEmpty()) QToolTip::showText(help->globalPos(), m_note, this);
    if (index < 0) return true;
    const auto& term = m_variable.terms[static_cast<std::size_t>(index)];
    const QStringList corners{numberText(term.set.a), numberText(term.set.b), numberText(term.set.c),
                              numberText(term.set.d)};
    QToolTip::showText(help->globalPos(), readableName(term.name) + ' ' + corners.join(QStringLiteral(" · ")),
                       this);
    return true;
}

} // namespace esm

#include "widgets/fuzzy/conclusion_view.h"

#include "widgets/fuzzy/small_font.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QMouseEvent>
#include <QPainterPath>

#include <algorithm>

namespace esm {

namespace {

QPolygonF outlinePolygon(const Outline& outline, const PlotFrame& frame) {
    QPolygonF polygon;
    for (const auto [x, degree] : outline)
        polygon << frame.at(x, degree);
    return polygon;
}

QColor conclusionTint(QColor colour, double alpha) {
    colour.setAlphaF(alpha);
    return colour;
}

} // namespace

ConclusionView::ConclusionView(QWidget* parent) : QWidget(parent) {
    setFont(smallFont(font()));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setObjectName(QStringLiteral("conclusionView"));
    setToolTip(tr("The terms, cut off at how strongly rules ask for them, and where their centre lies"));
}

void ConclusionView::setOutput(const FuzzyVariable& output, const QString& unit) {
    m_output = output;
    m_unit = unit;
    setAccessibleName(tr("What the rules conclude of %1").arg(readableName(output.name)));
    update();
}

void ConclusionView::setExplanation(OutputExplanation explanation) {
    m_explanation = std::move(explanation);
    tellSpoken(*this);
    update();
}

void ConclusionView::setChosenRule(std::optional<std::size_t> rule) {
    m_chosenRule = rule;
    update();
}

void ConclusionView::setHeld(std::optional<double> value) {
    m_held = value;
    tellSpoken(*this);
    update();
}

QString ConclusionView::textAt(std::optional<double> value) const {
    if (value) return tr("%1: %2").arg(withUnit(*value, m_unit), wordsFor(m_output, *value));
    const QString centre = m_explanation.value
                               ? tr("centre of gravity %1").arg(withUnit(*m_explanation.value, m_unit))
                               : tr("no rule reaches it");
    return m_held ? tr("held at %1, %2").arg(withUnit(*m_held, m_unit), centre) : centre;
}

PlotFrame ConclusionView::frame() const {
    const double line = QFontMetricsF(font()).height();
    const QRectF area = QRectF(rect()).adjusted(6, line + 6, -6, -line - 6);
    return {area, {m_output.minimum, m_output.maximum, m_unit}, {0, 1.06, {}}};
}

void ConclusionView::drawTerms(QPainter& painter, const PlotFrame& frame) const {
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    for (const FuzzyTerm& term : m_output.terms) {
        const Trapezoid& set = term.set;
        painter.drawPolyline(
            QPolygonF{{frame.at(set.a, 0), frame.at(set.b, 1), frame.at(set.c, 1), frame.at(set.d, 0)}});
    }
}

void ConclusionView::drawSets(QPainter& painter, const PlotFrame& frame) const {
    const QColor accent = palette().color(QPalette::Link);
    for (const ConcludedSet& set : m_explanation.sets) {
        const bool isChosen = m_chosenRule == set.rule;
        painter.setPen(QPen(conclusionTint(accent, isChosen ? 1 : 0.5), isChosen ? 2 : 1));
        painter.setBrush(conclusionTint(accent, isChosen ? 0.4 : 0.16));
        painter.drawPolygon(outlinePolygon(set.outline, frame));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(accent, 2));
    if (!m_explanation.sets.empty()) painter.drawPolyline(outlinePolygon(m_explanation.aggregated, frame));
}

void ConclusionView::drawValue(QPainter& painter, const PlotFrame& frame, double value,
                               const QColor& colour) const {
    const double x = frame.x(std::clamp(value, m_output.minimum, m_output.maximum));
    const QRectF& area = frame.area();
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setBrush(colour);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(
        QPolygonF{{{x - 4, area.bottom() + 7}, {x + 4, area.bottom() + 7}, {x, area.bottom() + 1}}});
    painter.setBrush(Qt::NoBrush);
}

void ConclusionView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotFrame shown = frame();
    painter.fillRect(shown.area(), palette().color(QPalette::Base));
    painter.save();
    painter.setClipRect(shown.area().adjusted(-1, 0, 1, 1));
    drawTerms(painter, shown);
    drawSets(painter, shown);
    painter.restore();
    shown.drawAcross(painter, palette());
    if (m_explanation.value)
        drawValue(painter, shown, *m_explanation.value,
                  palette().color(m_held ? QPalette::PlaceholderText : QPalette::WindowText));
    if (m_held) drawValue(painter, shown, *m_held, palette().color(QPalette::LinkVisited));
    if (m_pointed) {
        painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DotLine));
        painter.drawLine(shown.at(*m_pointed, 0), shown.at(*m_pointed, 1.06));
    }
    const bool isWarned = !m_pointed && (m_held || !m_explanation.value);
    painter.setPen(palette().color(isWarned ? QPalette::LinkVisited : QPalette::WindowText));
    painter.drawText(rect().adjusted(6, 1, -6, 0), Qt::AlignTop | Qt::AlignLeft,
                     fontMetrics().elidedText(textAt(m_pointed), Qt::ElideRight, width() - 12));
}

void ConclusionView::mouseMoveEvent(QMouseEvent* event) {
    m_pointed = frame().acrossAt(event->x());
    update();
}

void ConclusionView::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

} // namespace esm

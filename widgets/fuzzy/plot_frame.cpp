#include "widgets/fuzzy/plot_frame.h"

#include "core/fuzzy/partition_edits.h"

#include <QPalette>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double pixelsPerMark = 44, rowsPerMark = 24;

/// As few digits as tell neighbouring marks apart.
QString markText(double value) {
    return QString::number(value, 'g', 6).replace('-', QChar(0x2212));
}

int marksOver(double length, double perMark) {
    return std::max(2, static_cast<int>(length / perMark));
}

} // namespace

/// Marks are multiples of the step and not sums of steps, so that 0 is exactly 0 and no rounding gathers. The
/// slack keeps a mark at the range's very end.
std::vector<double> scaleMarks(const PlotRange& range, int most) {
    const double step = roundStep(range.width() / most);
    std::vector<double> marks;
    const double slack = 1e-9 * range.width();
    const double first = std::ceil((range.minimum - slack) / step);
    for (int i = 0; (first + i) * step <= range.maximum + slack; ++i)
        marks.push_back((first + i) * step);
    return marks;
}

double PlotFrame::x(double value) const {
    return m_area.left() + (value - m_across.minimum) / m_across.width() * m_area.width();
}

double PlotFrame::y(double value) const {
    return m_area.bottom() - (value - m_up.minimum) / m_up.width() * m_area.height();
}

double PlotFrame::acrossAt(double x) const {
    const double share = std::clamp((x - m_area.left()) / m_area.width(), 0.0, 1.0);
    return m_across.minimum + share * m_across.width();
}

double PlotFrame::upAt(double y) const {
    const double share = std::clamp((m_area.bottom() - y) / m_area.height(), 0.0, 1.0);
    return m_up.minimum + share * m_up.width();
}

void PlotFrame::drawAcross(QPainter& painter, const QPalette& palette) const {
    const QFontMetricsF metrics(painter.font());
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawLine(m_area.bottomLeft(), m_area.bottomRight());
    const std::vector<double> marks = scaleMarks(m_across, marksOver(m_area.width(), pixelsPerMark));
    for (const double mark : marks) {
        const bool isLast = mark == marks.back();
        const QString text = markText(mark) + (isLast && !m_across.unit.isEmpty() ? ' ' + m_across.unit : "");
        const double place = x(mark), width = metrics.horizontalAdvance(text);
        painter.drawLine(QPointF(place, m_area.bottom()), QPointF(place, m_area.bottom() + 3));
        const double left = std::clamp(place - width / 2, m_area.left() - 4,
                                       std::max(m_area.left(), m_area.right() + 4 - width));
        painter.drawText(QPointF(left, m_area.bottom() + 4 + metrics.ascent()), text);
    }
}

void PlotFrame::drawUpNumbers(QPainter& painter, const QPalette& palette, double perNumber) const {
    const QFontMetricsF metrics(painter.font());
    painter.setPen(palette.color(QPalette::PlaceholderText));
    for (const double mark : scaleMarks(m_up, marksOver(m_area.height(), perNumber))) {
        const QString text = markText(mark);
        painter.drawText(
            QPointF(m_area.left() - 5 - metrics.horizontalAdvance(text), y(mark) + metrics.capHeight() / 2),
            text);
    }
}

void PlotFrame::drawUp(QPainter& painter, const QPalette& palette) const {
    painter.setPen(palette.color(QPalette::Mid));
    for (const double mark : scaleMarks(m_up, marksOver(m_area.height(), rowsPerMark)))
        painter.drawLine(QPointF(m_area.left(), y(mark)), QPointF(m_area.right(), y(mark)));
    drawUpNumbers(painter, palette, rowsPerMark);
}

} // namespace esm

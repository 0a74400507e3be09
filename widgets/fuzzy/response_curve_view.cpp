#include "widgets/fuzzy/response_curve_view.h"

#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <algorithm>

namespace esm {

ResponseCurveView::ResponseCurveView(QWidget* parent) : ResponseView(parent) {
    setObjectName(QStringLiteral("responseCurve"));
    setToolTip(tr("A click or a drag sets the input, and so do the arrow keys"));
}

void ResponseCurveView::setAxes(const FuzzyVariable& input, const FuzzyVariable& outputVariable,
                                PlotRange output) {
    m_inputName = readableName(input.name);
    m_outputName = readableName(outputVariable.name);
    m_across = {input.minimum, input.maximum, QString::fromStdString(input.unit)};
    const double margin = 0.06 * output.width();
    m_output = {output.minimum - margin, output.maximum + margin, output.unit};
    m_curve.clear();
    setAccessibleName(tr("%1 over %2").arg(m_outputName, m_inputName));
    update();
}

void ResponseCurveView::setCurve(ResponseCurve curve) {
    m_curve = std::move(curve);
    for (const auto& piece : m_curve)
        for (const ResponsePoint& point : piece) {
            m_output.minimum = std::min(m_output.minimum, point.output);
            m_output.maximum = std::max(m_output.maximum, point.output);
        }
    update();
}

PlotFrame ResponseCurveView::frame() const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height(), numbers = metrics.horizontalAdvance(QStringLiteral("0000")) + 8;
    return {QRectF(rect()).adjusted(numbers, line + 6, -6, -line - 6), m_across, m_output};
}

std::optional<double> ResponseCurveView::outputAt(double input) const {
    const double slack = 1e-8 * m_across.width();
    for (const auto& piece : m_curve) {
        if (input < piece.front().input - slack || input > piece.back().input + slack) continue;
        const auto right = std::lower_bound(piece.begin(), piece.end(), input,
                                            [](const ResponsePoint& p, double x) { return p.input < x; });
        if (right == piece.end()) return piece.back().output;
        if (right == piece.begin()) return right->output;
        const ResponsePoint& left = *(right - 1);
        const double part = (input - left.input) / (right->input - left.input);
        return left.output + part * (right->output - left.output);
    }
    return std::nullopt;
}

QString ResponseCurveView::textAt(const std::optional<QPointF>& place) const {
    const auto input = place ? std::optional(frame().acrossAt(place->x())) : m_presentAcross;
    if (!input) return tr("%1 is left out").arg(m_inputName);
    const auto output = place ? outputAt(*input) : m_presentOutput;
    return tr("%1 %2: %3 %4")
        .arg(m_inputName, withUnit(*input, m_across.unit), m_outputName,
             output ? withUnit(*output, m_output.unit) : tr("not reached by any rule"));
}

void ResponseCurveView::draw(QPainter& painter, const PlotFrame& frame) {
    painter.fillRect(frame.area(), palette().color(QPalette::Base));
    frame.drawUp(painter, palette());
    frame.drawAcross(painter, palette());
    const QColor accent = palette().color(QPalette::Link);
    for (const auto& piece : m_curve) {
        QPolygonF line;
        for (const ResponsePoint& point : piece)
            line << frame.at(point.input, point.output);
        painter.setPen(QPen(accent, piece.size() > 1 ? 2 : 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (piece.size() > 1)
            painter.drawPolyline(line);
        else
            painter.drawPoint(line.front());
    }
    drawPresent(painter, frame);
    if (!m_pointed || m_isDragged) return;
    const double x = frame.acrossAt(m_pointed->x());
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DotLine));
    painter.drawLine(QPointF(frame.x(x), frame.area().top()), QPointF(frame.x(x), frame.area().bottom()));
    if (const auto output = outputAt(x)) {
        painter.setPen(QPen(accent, 1.5));
        painter.drawEllipse(frame.at(x, *output), 4, 4);
    }
}

void ResponseCurveView::drawPresent(QPainter& painter, const PlotFrame& frame) const {
    if (!m_presentAcross) return;
    const double x = frame.x(std::clamp(*m_presentAcross, m_across.minimum, m_across.maximum));
    const QColor text = palette().color(QPalette::WindowText);
    painter.setPen(QPen(text, 1, Qt::DashLine));
    painter.drawLine(QPointF(x, frame.area().top()), QPointF(x, frame.area().bottom()));
    if (!m_presentOutput) return;
    painter.setPen(QPen(text, 2));
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawEllipse(QPointF(x, frame.y(*m_presentOutput)), 5, 5);
    painter.setBrush(Qt::NoBrush);
}

} // namespace esm

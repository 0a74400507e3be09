#include "widgets/plot/curve_chart.h"

#include "widgets/inputs/number_text.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <qwt_plot_curve.h>
#include <qwt_plot_marker.h>
#include <qwt_symbol.h>

#include <algorithm>

namespace esm {

namespace {

constexpr int curveReach = 12;        ///< pixels, of the mouse
constexpr double besideCurves = 0.04; ///< of a scale, so that no end is cut
constexpr int valueDigits = 3;        ///< that anyone reads off a curve
constexpr double emptyScale = 1.0;    ///< to which scales go that nothing is drawn on
constexpr int mostDots = 50;          ///< of a curve: more would be a thick line
constexpr int besideMark = 5;         ///< pixels, from a line across to its text

QwtPlotCurve* addPressLine(QwtPlot& plot, double height) {
    auto* line = new QwtPlotCurve;
    line->setRenderHint(QwtPlotItem::RenderAntialiased);
    line->setZ(height);
    line->attach(&plot);
    return line;
}

} // namespace

CurveChart::CurveChart(QWidget* parent)
    : PlainPlot(parent), m_pointedMark(addPressLine(*this, 100)), m_moment(new QwtPlotMarker) {
    m_pointedMark->setStyle(QwtPlotCurve::NoCurve);
    m_moment->setLineStyle(QwtPlotMarker::VLine);
    m_moment->setVisible(false);
    m_moment->attach(this);
    canvas()->installEventFilter(this);
    CurveChart::followTheme();
    drawScales();
}

void CurveChart::setAxes(const ChartAxis& x, const ChartAxis& y) {
    m_x = x;
    m_y = y;
    const auto captionOf = [](const ChartAxis& axis) {
        return axis.quantity + QStringLiteral(", ") + axis.unit;
    };
    setAccessibleName(tr("%1 over %2").arg(y.quantity, x.quantity));
    setCaption(xBottom, captionOf(x), x.unit);
    setCaption(yLeft, captionOf(y), y.unit);
}

void CurveChart::setCurves(std::vector<ChartCurve> curves) {
    pointAt(std::nullopt);
    for (QwtPlotCurve* line : m_lines)
        delete line; // which detaches it
    m_lines.clear();
    m_curves = std::move(curves);
    // Dashes lie over the full line of the first curve, which shows between them where both agree.
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_lines.push_back(addPressLine(*this, 50 + static_cast<double>(i)));
        m_lines.back()->setSamples(m_curves[i].points);
    }
    followTheme();
    drawScales();
    tellSpoken(*this);
}

void CurveChart::setMoment(std::optional<double> x) {
    if (!x && !m_moment->isVisible()) return;
    m_moment->setVisible(x.has_value());
    if (x) m_moment->setXValue(*x);
    replot();
}

void CurveChart::drawScales() {
    double right = 0, top = 0;
    for (const ChartCurve& curve : m_curves)
        for (const QPointF& point : curve.points) {
            right = std::max(right, point.x());
            top = std::max(top, point.y());
        }
    setAxisScale(xBottom, 0, right > 0 ? (1 + besideCurves) * right : emptyScale);
    setAxisScale(yLeft, 0, top > 0 ? (1 + besideCurves) * top : emptyScale);
    replot();
}

QColor CurveChart::colourOf(std::size_t curve) const {
    return palette().color(curve == 0 ? QPalette::Link : QPalette::PlaceholderText);
}

void CurveChart::followTheme() {
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const QColor colour = colourOf(i);
        m_lines[i]->setPen(colour, i == 0 ? 2 : 1.4, i == 0 ? Qt::SolidLine : Qt::DashLine);
        const QSize dot = m_curves[i].points.size() > mostDots ? QSize() : i == 0 ? QSize(6, 6) : QSize(4, 4);
        m_lines[i]->setSymbol(
            new QwtSymbol(dot.isEmpty() ? QwtSymbol::NoSymbol : QwtSymbol::Ellipse, colour, Qt::NoPen, dot));
    }
    m_moment->setLinePen(palette().color(QPalette::WindowText), 1);
    m_pointedMark->setSymbol(
        new QwtSymbol(QwtSymbol::Ellipse, Qt::NoBrush, QPen(palette().color(QPalette::Link), 1.5), {15, 15}));
    PlainPlot::followTheme();
}

void CurveChart::drawCanvas(QPainter* painter) {
    PlainPlot::drawCanvas(painter);
    painter->setFont(axisFont(xBottom));
    drawMarks(*painter);
    if (m_curves.size() > 1) drawNames(*painter); // one curve needs none
}

/// Whether the first curve is highest in its first half.
bool CurveChart::isFalling() const {
    if (m_curves.empty() || m_curves.front().points.isEmpty()) return false;
    const auto& points = m_curves.front().points;
    const auto highest = std::max_element(points.begin(), points.end(),
                                          [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    return highest->x() < points.back().x() / 2 && highest->y() > points.back().y();
}

/// At the top left, which rising curves leave free, or at the top right.
void CurveChart::drawNames(QPainter& painter) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const int line = metrics.height() + 2;
    int width = 0;
    for (const ChartCurve& curve : m_curves)
        width = std::max(width, metrics.horizontalAdvance(curve.name));
    const QRect room = canvas()->contentsRect();
    const int left = isFalling() ? room.right() - width - 46 : 10;
    int y = room.top() + line;
    for (std::size_t i = 0; i < m_curves.size(); ++i, y += line) {
        painter.setPen(m_lines[i]->pen());
        painter.drawLine(left, y - line / 3, left + 20, y - line / 3);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(left + 26, y, m_curves[i].name);
    }
}

/// A text stands where the curve is not right of its line: low beside a rising curve, high beside a falling
/// one.
void CurveChart::drawMarks(QPainter& painter) const {
    const QFontMetrics metrics = painter.fontMetrics();
    const int line = metrics.height() + 2;
    const QRect room = canvas()->contentsRect();
    const int names = m_curves.size() > 1 ? static_cast<int>(m_curves.size()) : 0;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (!m_curves[i].mark) continue;
        const auto& [at, text] = *m_curves[i].mark;
        const int x = qRound(transform(xBottom, at));
        painter.setPen(QPen(colourOf(i), 1, Qt::DotLine));
        painter.drawLine(x, room.top(), x, room.bottom());
        const int row = static_cast<int>(i);
        const int y = isFalling() ? room.top() + (names + 1 + row) * line : room.bottom() - 6 - row * line;
        const int width = metrics.horizontalAdvance(text);
        const bool hasRoom = x + besideMark + width < room.right();
        painter.setPen(palette().color(i == 0 ? QPalette::WindowText : QPalette::PlaceholderText));
        painter.drawText(hasRoom ? x + besideMark : x - besideMark - width, y, text);
    }
}

QPoint CurveChart::placeOf(std::size_t curve, int point) const {
    const QPointF& value = m_curves[curve].points[point];
    return {qRound(transform(xBottom, value.x())), qRound(transform(yLeft, value.y()))};
}

std::optional<CurveChart::Spot> CurveChart::spotAt(const QPoint& place) const {
    std::optional<Spot> nearest;
    int least = curveReach * curveReach;
    for (std::size_t curve = 0; curve < m_curves.size(); ++curve)
        for (int point = 0; point < m_curves[curve].points.size(); ++point) {
            const QPoint away = placeOf(curve, point) - place;
            const int squared = QPoint::dotProduct(away, away);
            if (squared >= least) continue;
            least = squared;
            nearest = Spot{curve, point};
        }
    return nearest;
}

void CurveChart::pointAt(const std::optional<Spot>& spot) {
    if (spot == m_pointed) return;
    m_pointed = spot;
    m_pointedMark->setSamples(spot ? QVector<QPointF>{m_curves[spot->curve].points[spot->point]}
                                   : QVector<QPointF>());
    replot();
    if (spot)
        QToolTip::showText(canvas()->mapToGlobal(placeOf(spot->curve, spot->point) + QPoint(8, 8)),
                           textOf(*spot), canvas());
    else
        QToolTip::hideText();
    tellSpoken(*this);
}

QString CurveChart::textOf(const Spot& spot) const {
    const QPointF& value = m_curves[spot.curve].points[spot.point];
    const QString numbers = tr("%1: %2").arg(withUnit(value.x(), m_x.unit, valueDigits),
                                             withUnit(value.y(), m_y.unit, valueDigits));
    return m_curves.size() < 2 ? numbers : tr("%1, %2").arg(m_curves[spot.curve].name, numbers);
}

QString CurveChart::spokenValue() const {
    if (m_pointed) return textOf(*m_pointed);
    if (m_curves.empty()) return tr("nothing measured yet");
    QStringList ends;
    for (std::size_t curve = 0; curve < m_curves.size(); ++curve)
        if (!m_curves[curve].points.empty()) ends << textOf({curve, m_curves[curve].points.size() - 1});
    return ends.join(QStringLiteral("; "));
}

bool CurveChart::eventFilter(QObject* watched, QEvent* event) {
    if (watched == canvas()) {
        if (event->type() == QEvent::MouseMove) pointAt(spotAt(static_cast<QMouseEvent*>(event)->pos()));
        if (event->type() == QEvent::Leave) pointAt(std::nullopt);
    }
    return PlainPlot::eventFilter(watched, event);
}

void CurveChart::stepThrough(int direction) {
    if (m_curves.empty() || m_curves.front().points.empty()) return;
    const std::size_t curve = m_pointed ? m_pointed->curve : 0;
    const int last = m_curves[curve].points.size() - 1;
    const int from = m_pointed ? m_pointed->point + direction : direction > 0 ? 0 : last;
    pointAt(Spot{curve, std::clamp(from, 0, last)});
}

void CurveChart::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        stepThrough(event->key() == Qt::Key_Right ? 1 : -1);
    else
        PlainPlot::keyPressEvent(event);
}

void CurveChart::focusOutEvent(QFocusEvent* event) {
    PlainPlot::focusOutEvent(event);
    pointAt(std::nullopt);
}

} // namespace esm

#include "widgets/plot/accuracy_chart.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <qwt_plot_curve.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_engine.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int reach = 12; ///< pixels, of the mouse

QwtPlotCurve* addCurve(QwtPlot& plot, double height) {
    auto* curve = new QwtPlotCurve;
    curve->setStyle(QwtPlotCurve::NoCurve);
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->setZ(height);
    curve->attach(&plot);
    return curve;
}

QwtPlotMarker* addLine(QwtPlot& plot, QwtPlotMarker::LineStyle style) {
    auto* line = new QwtPlotMarker;
    line->setLineStyle(style);
    line->setZ(1);
    line->attach(&plot);
    return line;
}

/// The whole powers of ten around values above zero.
std::pair<double, double> decadesAround(double lowest, double highest) {
    const double low = std::floor(std::log10(lowest)), high = std::ceil(std::log10(highest));
    return {std::pow(10, low), std::pow(10, std::max(high, low + 1))};
}

} // namespace

AccuracyChart::AccuracyChart(QWidget* parent)
    : PlainPlot(parent), m_others(addCurve(*this, 2)), m_front(addCurve(*this, 3)),
      m_chosenMark(addCurve(*this, 6)), m_markedMark(addCurve(*this, 5)), m_pointedMark(addCurve(*this, 4)),
      m_realTime(addLine(*this, QwtPlotMarker::VLine)), m_mostError(addLine(*this, QwtPlotMarker::HLine)) {
    for (const int axis : {int(xBottom), int(yLeft)})
        setAxisScaleEngine(axis, new QwtLogScaleEngine);
    m_front->setStyle(QwtPlotCurve::Lines);
    m_realTime->setXValue(1);
    canvas()->installEventFilter(this);
    setAccessibleName(tr("Error over speed"));
    setToolTip(tr("A click marks a point, as the arrow keys do; a double click or Enter uses it"));
    setCaption(xBottom, tr("speed, times real time"), tr("speed, times real time"));
    setCaption(yLeft, tr("error, % of the motion"), tr("error, %"));
    AccuracyChart::followTheme();
    drawScales();
}

void AccuracyChart::setPoints(std::vector<AccuracyPoint> points, const std::vector<std::size_t>& front) {
    m_points = std::move(points);
    m_bySpeed.clear();
    std::vector<bool> isInFront(m_points.size(), false);
    for (const std::size_t i : front)
        isInFront[i] = true;
    QVector<QPointF> others, best;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (!isDrawn(i)) continue;
        m_bySpeed.push_back(i);
        (isInFront[i] ? best : others).push_back({m_points[i].speed, 100 * m_points[i].error});
    }
    std::sort(m_bySpeed.begin(), m_bySpeed.end(),
              [&](std::size_t a, std::size_t b) { return m_points[a].speed < m_points[b].speed; });
    std::sort(best.begin(), best.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
    m_others->setSamples(others);
    m_front->setSamples(best);
    setChosen(std::nullopt);
    mark(std::nullopt);
    point(std::nullopt);
    drawScales();
}

bool AccuracyChart::isDrawn(std::size_t point) const {
    const auto hasPlace = [](double value) { return value > 0 && std::isfinite(value); };
    return hasPlace(m_points[point].speed) && hasPlace(m_points[point].error);
}

void AccuracyChart::drawScales() {
    double slowest = 1, fastest = 1, least = m_mostError->yValue() > 0 ? m_mostError->yValue() : 1,
           most = least;
    for (const std::size_t i : m_bySpeed) {
        slowest = std::min(slowest, m_points[i].speed);
        fastest = std::max(fastest, m_points[i].speed);
        least = std::min(least, 100 * m_points[i].error);
        most = std::max(most, 100 * m_points[i].error);
    }
    const auto speeds = decadesAround(slowest, fastest), errors = decadesAround(least, most);
    setAxisScale(xBottom, speeds.first, speeds.second);
    setAxisScale(yLeft, errors.first, errors.second);
    replot();
}

void AccuracyChart::setChosen(std::optional<std::size_t> point) {
    m_chosen = point && isDrawn(*point) ? point : std::nullopt;
    ring(m_chosenMark, m_chosen);
}

void AccuracyChart::mark(std::optional<std::size_t> point) {
    m_marked = point && *point < m_points.size() && isDrawn(*point) ? point : std::nullopt;
    ring(m_markedMark, m_marked);
    tellSpoken(*this);
}

void AccuracyChart::ring(QwtPlotCurve* mark, std::optional<std::size_t> point) {
    QVector<QPointF> places;
    if (point) places.push_back({m_points[*point].speed, 100 * m_points[*point].error});
    mark->setSamples(places);
    replot();
}

void AccuracyChart::setMostError(double error) {
    m_mostError->setYValue(100 * error);
    drawScales();
}

QString AccuracyChart::spokenValue() const {
    const auto said = m_pointed ? m_pointed : m_marked ? m_marked : m_chosen;
    return said ? m_points[*said].text : tr("%1 ways to compute, none in use").arg(m_bySpeed.size());
}

QPoint AccuracyChart::placeOf(std::size_t point) const {
    return {qRound(transform(xBottom, m_points[point].speed)),
            qRound(transform(yLeft, 100 * m_points[point].error))};
}

std::optional<std::size_t> AccuracyChart::pointAt(const QPoint& place) const {
    std::optional<std::size_t> nearest;
    int distance = reach * reach;
    for (const std::size_t i : m_bySpeed) {
        const QPoint away = placeOf(i) - place;
        const int squared = QPoint::dotProduct(away, away);
        if (squared > distance) continue;
        distance = squared;
        nearest = i;
    }
    return nearest;
}

void AccuracyChart::point(std::optional<std::size_t> point) {
    m_pointed = point;
    ring(m_pointedMark, point);
    canvas()->setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (point)
        explain(*point);
    else
        QToolTip::hideText();
}

void AccuracyChart::explain(std::size_t point) {
    QToolTip::showText(canvas()->mapToGlobal(placeOf(point) + QPoint(8, 8)), m_points[point].text, canvas());
}

void AccuracyChart::followMouse(QEvent* event) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    const auto under = pointAt(mouse->pos());
    if (event->type() == QEvent::MouseMove) {
        if (under != m_pointed) point(under);
    } else if (under && mouse->button() == Qt::LeftButton) {
        mark(under);
        emit marked(*under);
        if (event->type() == QEvent::MouseButtonDblClick) emit chosen(*under);
    }
}

bool AccuracyChart::eventFilter(QObject* watched, QEvent* event) {
    if (watched != canvas()) return PlainPlot::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        followMouse(event);
        break;
    case QEvent::Leave:
        point(std::nullopt);
        break;
    default:
        break;
    }
    return PlainPlot::eventFilter(watched, event);
}

void AccuracyChart::stepThrough(int direction) {
    if (m_bySpeed.empty()) return;
    const auto from = m_marked ? m_marked : m_chosen;
    const auto at = from ? std::find(m_bySpeed.begin(), m_bySpeed.end(), *from) : m_bySpeed.end();
    const auto last = static_cast<std::ptrdiff_t>(m_bySpeed.size()) - 1;
    const auto place =
        at == m_bySpeed.end() ? (direction > 0 ? 0 : last) : (at - m_bySpeed.begin()) + direction;
    if (place < 0 || place > last) return;
    mark(m_bySpeed[static_cast<std::size_t>(place)]);
    explain(*m_marked);
    emit marked(*m_marked);
}

void AccuracyChart::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        stepThrough(event->key() == Qt::Key_Right ? 1 : -1);
    else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && m_marked)
        emit chosen(*m_marked);
    else
        PlainPlot::keyPressEvent(event);
}

void AccuracyChart::focusInEvent(QFocusEvent* event) {
    PlainPlot::focusInEvent(event);
    if (event->reason() != Qt::MouseFocusReason && !m_marked) stepThrough(1);
}

void AccuracyChart::focusOutEvent(QFocusEvent* event) {
    PlainPlot::focusOutEvent(event);
    point(std::nullopt);
}

void AccuracyChart::followTheme() {
    const QPalette colours = palette();
    const QColor &quiet = colours.color(QPalette::PlaceholderText), &bright = colours.color(QPalette::Link),
                 &text = colours.color(QPalette::WindowText), &wish = colours.color(QPalette::LinkVisited);
    const auto dot = [](QwtSymbol::Style style, const QBrush& brush, const QPen& pen, int size) {
        return new QwtSymbol(style, brush, pen, {size, size});
    };
    m_others->setSymbol(dot(QwtSymbol::Ellipse, quiet, Qt::NoPen, 4));
    m_front->setSymbol(dot(QwtSymbol::Ellipse, bright, Qt::NoPen, 7));
    m_front->setPen(bright, 1.2);
    m_chosenMark->setSymbol(dot(QwtSymbol::Ellipse, Qt::NoBrush, QPen(text, 2), 13));
    m_markedMark->setSymbol(dot(QwtSymbol::Ellipse, Qt::NoBrush, QPen(bright, 2.5), 17));
    m_pointedMark->setSymbol(dot(QwtSymbol::Ellipse, Qt::NoBrush, QPen(bright, 1.5), 17));
    m_realTime->setLinePen(wish, 1, Qt::DashLine);
    m_mostError->setLinePen(wish, 1, Qt::DashLine);
    PlainPlot::followTheme();
}

} // namespace esm

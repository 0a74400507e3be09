#include "widgets/plot/accuracy_chart.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int reach = 12;     ///< pixels, of the mouse
constexpr int mostLabels = 8; ///< of a scale

/// "1000" rather than "1e+03", and no more digits than a power of ten needs.
class PlainScale : public QwtScaleDraw {
public:
    QwtText label(double value) const override { return QwtText(QString::number(value, 'g', 6)); }
};

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
    : QwtPlot(parent), m_others(addCurve(*this, 2)), m_front(addCurve(*this, 3)),
      m_chosenMark(addCurve(*this, 6)), m_markedMark(addCurve(*this, 5)), m_pointedMark(addCurve(*this, 4)),
      m_realTime(addLine(*this, QwtPlotMarker::VLine)), m_mostError(addLine(*this, QwtPlotMarker::HLine)) {
    auto* grid = new QwtPlotGrid;
    grid->attach(this);
    for (const int axis : {int(xBottom), int(yLeft)}) {
        setAxisScaleEngine(axis, new QwtLogScaleEngine);
        setAxisScaleDraw(axis, new PlainScale);
        setAxisMaxMinor(axis, 0);
        axisWidget(axis)->setMargin(0);
    }
    m_front->setStyle(QwtPlotCurve::Lines);
    m_realTime->setXValue(1);
    auto* frame = qobject_cast<QwtPlotCanvas*>(canvas());
    frame->setFrameStyle(QFrame::NoFrame);
    frame->setFocusPolicy(Qt::NoFocus);
    frame->setMouseTracking(true);
    frame->installEventFilter(this);
    frame->setCursor(Qt::ArrowCursor);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Error over speed"));
    setToolTip(tr("Click a point, or choose one with the arrow keys and Enter, to compute so"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    followTheme();
    drawScales();
}

void AccuracyChart::setPoints(std::vector<AccuracyPoint> points, const std::vector<std::size_t>& front) {
    m_points = std::move(points);
    m_bySpeed.clear();
    QVector<QPointF> others, best;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (!isDrawn(i)) continue;
        m_bySpeed.push_back(i);
        const bool isBest = std::find(front.begin(), front.end(), i) != front.end();
        (isBest ? best : others).push_back({m_points[i].speed, 100 * m_points[i].error});
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

void AccuracyChart::setEmptyText(const QString& text) {
    m_emptyText = text;
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
    if (watched != canvas()) return QwtPlot::eventFilter(watched, event);
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
    return QwtPlot::eventFilter(watched, event);
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
        QwtPlot::keyPressEvent(event);
}

void AccuracyChart::focusInEvent(QFocusEvent* event) {
    QwtPlot::focusInEvent(event);
    if (event->reason() != Qt::MouseFocusReason && !m_marked) stepThrough(1);
}

void AccuracyChart::focusOutEvent(QFocusEvent* event) {
    QwtPlot::focusOutEvent(event);
    point(std::nullopt);
}

bool AccuracyChart::event(QEvent* event) {
    const bool taken = QwtPlot::event(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) followTheme();
    return taken;
}

// A style sheet that changes gives the canvas back the palette that it had first: it cannot hold the colour.
void AccuracyChart::drawCanvas(QPainter* painter) {
    painter->fillRect(canvas()->contentsRect(), palette().color(QPalette::Base));
    QwtPlot::drawCanvas(painter);
    if (!m_bySpeed.empty()) return;
    painter->setPen(palette().color(QPalette::PlaceholderText));
    painter->drawText(canvas()->contentsRect().adjusted(24, 12, -24, -12), Qt::AlignCenter | Qt::TextWordWrap,
                      m_emptyText);
}

void AccuracyChart::followTheme() {
    const QPalette colours = palette();
    const QColor &quiet = colours.color(QPalette::PlaceholderText), &line = colours.color(QPalette::Mid),
                 &bright = colours.color(QPalette::Link), &text = colours.color(QPalette::WindowText),
                 &wish = colours.color(QPalette::LinkVisited);
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
    for (QwtPlotItem* item : itemList(QwtPlotItem::Rtti_PlotGrid))
        static_cast<QwtPlotGrid*>(item)->setPen(line, 0, Qt::DotLine);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    for (const int axis : {int(xBottom), int(yLeft)}) {
        setAxisFont(axis, small);
        QPalette scale = axisWidget(axis)->palette();
        scale.setColor(QPalette::WindowText, line);
        scale.setColor(QPalette::Text, quiet);
        axisWidget(axis)->setPalette(scale);
    }
    fitScales();
    replot();
}

// As many numbers, and as much of a caption, as have room.
void AccuracyChart::fitScales() {
    const QFont small = axisFont(xBottom);
    const QFontMetrics metrics(small);
    const auto caption = [&](int axis, const QString& words) {
        QwtText titled(words);
        titled.setFont(small);
        titled.setColor(palette().color(QPalette::PlaceholderText));
        setAxisTitle(axis, titled);
    };
    const QString error = tr("error, % of the motion");
    caption(xBottom, tr("speed, times real time"));
    caption(yLeft, metrics.horizontalAdvance(error) < canvas()->height() ? error : tr("error, %"));
    const int widest = metrics.horizontalAdvance(QStringLiteral("1000000"));
    setAxisMaxMajor(xBottom, std::clamp(canvas()->width() / widest, 2, mostLabels));
    setAxisMaxMajor(yLeft, std::clamp(canvas()->height() / (2 * metrics.height()), 2, mostLabels));
}

void AccuracyChart::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    fitScales();
    replot();
}

} // namespace esm

#include "widgets/plot/plain_plot.h"

#include <QEvent>
#include <QPainter>

#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <algorithm>

namespace esm {

namespace {

constexpr int mostLabels = 8; ///< of a scale

/// "1000" rather than "1e+03", and no more digits than a power of ten needs.
class PlainScale : public QwtScaleDraw {
public:
    void setColour(const QColor& colour) {
        m_colour = colour;
        invalidateCache();
    }

    QwtText label(double value) const override {
        QwtText text(QString::number(value, 'g', 6));
        text.setColor(m_colour);
        return text;
    }

private:
    QColor m_colour;
};

} // namespace

PlainPlot::PlainPlot(QWidget* parent) : QwtPlot(parent) {
    auto* grid = new QwtPlotGrid;
    grid->attach(this);
    for (const int axis : {int(xBottom), int(yLeft)}) {
        setAxisScaleDraw(axis, new PlainScale);
        setAxisMaxMinor(axis, 0);
        axisWidget(axis)->setMargin(0);
    }
    auto* frame = qobject_cast<QwtPlotCanvas*>(canvas());
    frame->setFrameStyle(QFrame::NoFrame);
    frame->setFocusPolicy(Qt::NoFocus);
    frame->setMouseTracking(true);
    frame->setCursor(Qt::ArrowCursor);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlainPlot::setEmptyText(const QString& text) {
    m_emptyText = text;
    replot();
}

void PlainPlot::setCaption(int axis, const QString& whole, const QString& brief) {
    m_captions[axis] = {whole, brief};
    fitScales();
}

bool PlainPlot::event(QEvent* event) {
    const bool taken = QwtPlot::event(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) followTheme();
    return taken;
}

// A style sheet that changes gives the canvas back the palette that it had first: it cannot hold the colour,
// nor can a scale that of its numbers.
void PlainPlot::drawCanvas(QPainter* painter) {
    painter->fillRect(canvas()->contentsRect(), palette().color(QPalette::Base));
    QwtPlot::drawCanvas(painter);
    if (!isBlank()) return;
    painter->setPen(palette().color(QPalette::PlaceholderText));
    painter->drawText(canvas()->contentsRect().adjusted(24, 12, -24, -12), Qt::AlignCenter | Qt::TextWordWrap,
                      m_emptyText);
}

void PlainPlot::followTheme() {
    const QPalette colours = palette();
    const QColor &quiet = colours.color(QPalette::PlaceholderText), &line = colours.color(QPalette::Mid);
    for (QwtPlotItem* item : itemList(QwtPlotItem::Rtti_PlotGrid))
        static_cast<QwtPlotGrid*>(item)->setPen(line, 0, Qt::DotLine);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    for (const int axis : {int(xBottom), int(yLeft)}) {
        setAxisFont(axis, small);
        QPalette scale = axisWidget(axis)->palette();
        scale.setColor(QPalette::WindowText, line);
        axisWidget(axis)->setPalette(scale);
        static_cast<PlainScale*>(axisScaleDraw(axis))->setColour(quiet);
    }
    fitScales();
    replot();
}

// As many numbers, and as much of a caption, as have room.
void PlainPlot::fitScales() {
    const QFont small = axisFont(xBottom);
    const QFontMetrics metrics(small);
    for (const auto& [axis, caption] : m_captions) {
        const int room = axis == xBottom ? canvas()->width() : canvas()->height();
        QwtText titled(metrics.horizontalAdvance(caption.whole) < room ? caption.whole : caption.brief);
        titled.setFont(small);
        titled.setColor(palette().color(QPalette::PlaceholderText));
        setAxisTitle(axis, titled);
    }
    const int widest = metrics.horizontalAdvance(QStringLiteral("1000000"));
    setAxisMaxMajor(xBottom, std::clamp(canvas()->width() / widest, 2, mostLabels));
    setAxisMaxMajor(yLeft, std::clamp(canvas()->height() / (2 * metrics.height()), 2, mostLabels));
}

void PlainPlot::resizeEvent(QResizeEvent* event) {
    QwtPlot::resizeEvent(event);
    fitScales();
    replot();
}

} // namespace esm

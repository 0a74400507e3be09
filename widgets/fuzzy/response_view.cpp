#include "widgets/fuzzy/response_view.h"

#include "widgets/fuzzy/small_font.h"
#include "widgets/inputs/gesture.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace esm {

namespace {

constexpr double keyStep = 0.01; ///< of an input's range

} // namespace

ResponseView::ResponseView(QWidget* parent) : QWidget(parent) {
    setFont(smallFont(font()));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseBetweenGestures);
    connect(&m_pause, &QTimer::timeout, this, &ResponseView::gestureFinished);
}

void ResponseView::setPresent(std::optional<double> across, std::optional<double> up,
                              std::optional<double> output) {
    m_presentAcross = across;
    m_presentUp = up;
    m_presentOutput = output;
    setAccessibleDescription(textAt(std::nullopt));
    update();
}

void ResponseView::setStale(bool stale) {
    m_isStale = stale;
    update();
}

void ResponseView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotFrame shown = frame();
    painter.save();
    if (m_isStale) painter.setOpacity(0.35);
    draw(painter, shown);
    painter.restore();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(6, 1, -6, 0), Qt::AlignTop | Qt::AlignLeft,
                     fontMetrics().elidedText(textAt(m_pointed), Qt::ElideRight, width() - 12));
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(QPalette::Link));
    painter.drawRect(shown.area().adjusted(-1.5, -1.5, 1.5, 1.5));
}

void ResponseView::setFrom(const QPointF& place) {
    const PlotFrame shown = frame();
    emit inputsSet(shown.acrossAt(place.x()), shown.upAt(place.y()));
}

void ResponseView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isEnabled()) return;
    finish();
    m_isDragged = true;
    m_pointed = event->localPos();
    setFrom(event->localPos());
}

void ResponseView::mouseMoveEvent(QMouseEvent* event) {
    m_pointed = event->localPos();
    if (m_isDragged) setFrom(event->localPos());
    update();
}

void ResponseView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_isDragged) return;
    m_isDragged = false;
    emit gestureFinished();
}

void ResponseView::keyPressEvent(QKeyEvent* event) {
    const int across = (event->key() == Qt::Key_Right) - (event->key() == Qt::Key_Left);
    const int up = (event->key() == Qt::Key_Up) - (event->key() == Qt::Key_Down);
    const double stepsUp = stepUp();
    if ((across == 0 && (up == 0 || stepsUp == 0)) || !m_presentAcross) return QWidget::keyPressEvent(event);
    const double x = *m_presentAcross + across * keyStep * m_across.width();
    const double y = m_presentUp.value_or(0) + up * stepsUp;
    m_pause.start();
    emit inputsSet(std::clamp(x, m_across.minimum, m_across.maximum), y);
}

void ResponseView::finish() {
    if (!m_pause.isActive()) return;
    m_pause.stop();
    emit gestureFinished();
}

void ResponseView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    finish();
}

void ResponseView::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

} // namespace esm

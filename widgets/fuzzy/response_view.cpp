#include "widgets/fuzzy/response_view.h"

#include "widgets/fuzzy/small_font.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double keyStep = 0.01;   ///< of an input's range
constexpr double presentReach = 3; ///< pixels

} // namespace

ResponseView::ResponseView(QWidget* parent) : QWidget(parent) {
    setFont(smallFont(font()));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ResponseView::setInputs(std::optional<double> across, std::optional<double> up) {
    m_setAcross = across;
    m_setUp = up;
}

void ResponseView::setPresent(std::optional<double> across, std::optional<double> up,
                              std::optional<double> output) {
    m_presentAcross = across;
    m_presentUp = up;
    m_presentOutput = output;
    tellSpoken(*this);
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
                     fontMetrics().elidedText(said(), Qt::ElideRight, width() - 12));
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(QPalette::Link));
    painter.drawRect(shown.area().adjusted(-1.5, -1.5, 1.5, 1.5));
}

void ResponseView::setFrom(const QPointF& place) {
    const PlotFrame shown = frame();
    emit inputsSet(shown.acrossAt(place.x()),
                   stepUp() > 0 ? std::optional(shown.upAt(place.y())) : std::nullopt);
}

/// At the present place, and while it is drawn along, the output is known, and not only as it is drawn.
std::optional<QPointF> ResponseView::spokenPlace() const {
    if (!m_pointed || m_isDragged || !m_presentAcross) return m_isDragged ? std::nullopt : m_pointed;
    const PlotFrame shown = frame();
    const bool isOnCurve = stepUp() == 0;
    const QPointF present(shown.x(*m_presentAcross),
                          isOnCurve || !m_presentUp ? m_pointed->y() : shown.y(*m_presentUp));
    const QPointF off = *m_pointed - present;
    const bool isPresent = (isOnCurve || m_presentUp) && std::hypot(off.x(), off.y()) <= presentReach;
    return isPresent ? std::nullopt : m_pointed;
}

void ResponseView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isEnabled()) return;
    m_keys.finish();
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
    std::optional<double> x, y;
    if (across != 0 && m_setAcross) x = *m_setAcross + across * keyStep * m_across.width();
    if (up != 0 && m_setUp && stepUp() > 0) y = *m_setUp + up * stepUp();
    if (!x && !y) return QWidget::keyPressEvent(event);
    if (x) x = std::clamp(*x, m_across.minimum, m_across.maximum);
    m_keys.goOn();
    emit inputsSet(x, y);
}

void ResponseView::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    m_keys.finish();
}

void ResponseView::leaveEvent(QEvent*) {
    m_pointed.reset();
    update();
}

} // namespace esm

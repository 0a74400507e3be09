#include "widgets/inputs/key_pointer.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>

namespace esm {

namespace {

constexpr double keyReach = 10; ///< pixels that an arrow key moves the mark
constexpr int markSide = 27;    ///< pixels
constexpr int wheelPerNotch = 120;
constexpr double focusFrame = 2; ///< pixels

/// A cross with an open middle, light with a dark edge, so that it is seen on any tissue; a filled middle
/// while it presses.
class PointerMark : public QWidget {
public:
    PointerMark(QWidget* parent, const bool& isPressing) : QWidget(parent), m_isPressing(isPressing) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFixedSize(markSide, markSide);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPointF middle(markSide / 2.0, markSide / 2.0);
        for (const QPen& pen : {QPen(Qt::black, 4), QPen(Qt::white, 2)}) {
            painter.setPen(pen);
            for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
                painter.drawLine(middle + 5 * way, middle + 12 * way);
            if (m_isPressing) painter.drawEllipse(middle, 3, 3);
        }
    }

private:
    const bool& m_isPressing;
};

QPointF wayOf(int key) {
    return {double(key == Qt::Key_Right) - double(key == Qt::Key_Left),
            double(key == Qt::Key_Down) - double(key == Qt::Key_Up)};
}

} // namespace

KeyPointer::KeyPointer(QWidget& area)
    : QObject(&area), m_area(area), m_mark(new PointerMark(&area, m_isPressing)) {
    area.installEventFilter(this);
}

std::optional<QPointF> KeyPointer::place() const {
    return m_mark->isHidden() ? std::nullopt : m_place;
}

bool KeyPointer::press(const QKeyEvent& key) {
    if (!wayOf(key.key()).isNull()) {
        moveBy(key);
        return true;
    }
    if (!place()) return false;
    switch (key.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        toggle(key.modifiers() & ~Qt::KeypadModifier);
        return true;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
        turnWheel(key.key() == Qt::Key_PageUp ? 1 : -1, key.modifiers());
        return true;
    default:
        return false;
    }
}

/// The first key only shows where it is.
void KeyPointer::moveBy(const QKeyEvent& key) {
    if (!place()) return show();
    const double reach = key.modifiers() & Qt::ShiftModifier ? 1 : keyReach;
    moveTo(*m_place + reach * wayOf(key.key()));
}

void KeyPointer::show() {
    m_keys = {};
    m_mark->show();
    m_mark->raise();
    moveTo(m_place.value_or(m_area.rect().center()));
}

void KeyPointer::moveTo(const QPointF& place) {
    m_place = {std::clamp(place.x(), 0.0, m_area.width() - 1.0),
               std::clamp(place.y(), 0.0, m_area.height() - 1.0)};
    m_mark->move(m_place->toPoint() - QPoint(markSide / 2, markSide / 2));
    send(QEvent::MouseMove, Qt::NoButton);
}

void KeyPointer::toggle(Qt::KeyboardModifiers keys) {
    m_isPressing = !m_isPressing;
    if (m_isPressing) m_keys = keys;
    send(m_isPressing ? QEvent::MouseButtonPress : QEvent::MouseButtonRelease, Qt::LeftButton);
    if (!m_isPressing) m_keys = {};
    m_mark->update();
}

void KeyPointer::turnWheel(int notches, Qt::KeyboardModifiers keys) {
    const QPointF global = m_area.mapToGlobal(m_place->toPoint());
    QWheelEvent event(*m_place, global, {}, {0, wheelPerNotch * notches}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&m_area, &event);
}

/// A button that was just let go is held no more.
void KeyPointer::send(QEvent::Type type, Qt::MouseButton button) {
    const Qt::MouseButtons held = m_isPressing ? Qt::LeftButton : Qt::NoButton;
    QMouseEvent event(type, *m_place, m_area.mapToGlobal(m_place->toPoint()), button, held, m_keys);
    m_isSending = true;
    QCoreApplication::sendEvent(&m_area, &event);
    m_isSending = false;
}

bool KeyPointer::goToNextStop(bool forwards) {
    if (!place() || !m_stops || m_isPressing) return false;
    std::vector<QPointF> stops = m_stops();
    std::erase_if(stops, [&](const QPointF& stop) { return !m_area.rect().contains(stop.toPoint()); });
    if (!forwards) std::reverse(stops.begin(), stops.end());
    const auto at = std::find(stops.begin(), stops.end(), *m_place);
    const auto next = at == stops.end() ? stops.begin() : at + 1;
    if (next == stops.end()) return false;
    moveTo(*next);
    return true;
}

void KeyPointer::hide() {
    if (m_isPressing) toggle({});
    m_mark->hide();
}

void KeyPointer::paintFocus(QPainter& painter) const {
    if (!m_cameByTab || !m_area.hasFocus()) return;
    painter.save();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_area.palette().color(QPalette::Link), focusFrame));
    constexpr double inside = focusFrame / 2;
    painter.drawRect(QRectF(m_area.rect()).adjusted(inside, inside, -inside, -inside));
    painter.restore();
}

void KeyPointer::followFocus(const QEvent& event) {
    if (event.type() != QEvent::FocusIn && event.type() != QEvent::MouseButtonPress) return;
    const bool isFocus = event.type() == QEvent::FocusIn;
    const auto reason = isFocus ? static_cast<const QFocusEvent&>(event).reason() : Qt::MouseFocusReason;
    m_cameByTab = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason;
    m_area.update();
}

bool KeyPointer::eventFilter(QObject*, QEvent* event) {
    if (!m_isSending) followFocus(*event);
    const bool isMouse = event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress;
    if (!place() || m_isSending || (!isMouse && event->type() != QEvent::FocusOut)) return false;
    hide();
    return false;
}

} // namespace esm

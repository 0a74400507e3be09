#include "widgets/inputs/value_slider.h"

#include <QWheelEvent>

#include <chrono>

namespace esm {

namespace {

/// Longer than keys and wheel rest within one movement.
constexpr std::chrono::milliseconds pauseBetweenGestures{600};

} // namespace

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    // Not by the wheel: it would take the focus from where the user types.
    setFocusPolicy(Qt::StrongFocus);
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseBetweenGestures);
    connect(&m_pause, &QTimer::timeout, this, &ValueSlider::gestureFinished);
    connect(this, &QSlider::sliderReleased, this, &ValueSlider::finish);
    connect(this, &QSlider::valueChanged, this, [this] {
        if (!isSliderDown()) m_pause.start();
    });
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

void ValueSlider::focusOutEvent(QFocusEvent* event) {
    QSlider::focusOutEvent(event);
    if (m_pause.isActive()) finish();
}

void ValueSlider::finish() {
    m_pause.stop();
    emit gestureFinished();
}

} // namespace esm

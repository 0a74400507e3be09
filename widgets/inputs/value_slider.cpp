#include "widgets/inputs/value_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr qreal focusRing = 2; ///< pixels wide

} // namespace

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    // Not by the wheel: it would take the focus from where the user types.
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QSlider::sliderReleased, this, &ValueSlider::gestureFinished);
    connect(this, &QSlider::valueChanged, this, [this] {
        if (!isSliderDown()) m_keys.goOn();
    });
}

void ValueSlider::setScale(double least, double most) {
    m_least = least;
    m_most = most;
    m_isLogarithmic = false;
}

void ValueSlider::setLogarithmicScale(double least, double most) {
    setScale(least, most);
    m_isLogarithmic = true;
}

double ValueSlider::scaledAt(int position) const {
    const double share = (position - minimum()) / std::max(1.0, static_cast<double>(maximum()) - minimum());
    return m_isLogarithmic ? m_least * std::pow(m_most / m_least, share)
                           : m_least + share * (m_most - m_least);
}

void ValueSlider::setScaledValue(double number) {
    const double share = m_isLogarithmic ? std::log(number / m_least) / std::log(m_most / m_least)
                                         : (number - m_least) / (m_most - m_least);
    setValue(minimum() + qRound(share * (maximum() - minimum())));
}

void ValueSlider::setSpoken(const QString& value) {
    if (value == m_spoken) return;
    m_spoken = value;
    tellSpoken(*this);
}

std::optional<SpokenNumber> ValueSlider::spokenNumber() const {
    const double step = scaledAt(value() + singleStep()) - scaledValue();
    return SpokenNumber{scaledValue(), m_least, m_most, step};
}

QRect ValueSlider::handleRect() const {
    QStyleOptionSlider option;
    initStyleOption(&option);
    return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

void ValueSlider::bringHandleTo(int left) {
    const int room = width() - handleWidth();
    setSliderPosition(QStyle::sliderValueFromPosition(minimum(), maximum(), left, room));
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isSliderDown()) return event->ignore();
    // What the keys or the wheel moved a moment ago is an edit of its own.
    m_keys.finish();
    const QRect handle = handleRect();
    const bool onHandle = handle.contains(event->pos());
    m_grabbedAt = onHandle ? event->x() - handle.left() : handle.width() / 2;
    setSliderDown(true);
    if (!onHandle) bringHandleTo(event->x() - m_grabbedAt);
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (isSliderDown()) bringHandleTo(event->x() - m_grabbedAt);
}

void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) setSliderDown(false);
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

void ValueSlider::paintEvent(QPaintEvent* event) {
    QSlider::paintEvent(event);
    if (!hasFocus()) return;
    // A style sheet does not tell handles whether their slider has the focus.
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Text), focusRing));
    constexpr qreal inside = focusRing / 2;
    painter.drawEllipse(QRectF(handleRect()).adjusted(inside, inside, -inside, -inside));
}

void ValueSlider::focusOutEvent(QFocusEvent* event) {
    QSlider::focusOutEvent(event);
    m_keys.finish();
}

} // namespace esm

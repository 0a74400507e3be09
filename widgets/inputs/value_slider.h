#pragma once

#include "widgets/inputs/gesture.h"
#include "widgets/inputs/spoken.h"

#include <QSlider>

namespace esm {

/// A slider that says when a movement of its handle is over, by whatever it was moved: mouse, keys or wheel.
/// A press beside the handle brings it there, and it follows the mouse until the button is let go. The wheel
/// moves it only while it has the focus, so that a panel scrolls beneath the mouse.
class ValueSlider : public QSlider, public Spoken {
    Q_OBJECT

public:
    explicit ValueSlider(QWidget* parent = nullptr);

    /// As it is drawn, pixels. Half of it is how far from either end the handle's middle stays.
    int handleWidth() const { return handleRect().width(); }

    /// How long keys and wheel rest before what follows is another edit.
    void setPause(std::chrono::milliseconds pause) { m_keys.setPause(pause); }

    /// What its ends stand for, in the unit that is shown: a screen reader is told that, and no position.
    void setScale(double least, double most);
    /// The same where every step multiplies by one factor.
    void setLogarithmicScale(double least, double most);
    /// The number at the handle.
    double scaledValue() const { return scaledAt(value()); }
    /// Brings the handle as near to a number as steps allow.
    void setScaledValue(double number);
    /// The value as it is said: "1.2 N/m, flexible 0.92".
    void setSpoken(const QString& value);
    QString spokenValue() const override { return m_spoken; }
    std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double number) override { setScaledValue(number); }
    QAccessible::Role spokenRole() const override { return QAccessible::Slider; }

signals:
    /// The handle was let go, the focus left, or nothing moved for a moment: what follows is another edit.
    void gestureFinished();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QRect handleRect() const;
    double scaledAt(int position) const;
    void bringHandleTo(int left);

    KeyRun m_keys{[this] { emit gestureFinished(); }};
    double m_least = 0, m_most = 1;
    bool m_isLogarithmic = false;
    QString m_spoken;
    int m_grabbedAt = 0; ///< from the handle's left to where the mouse holds it, pixels
};

} // namespace esm

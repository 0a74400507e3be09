#pragma once

#include <QSlider>
#include <QTimer>

namespace esm {

/// A slider that says when a movement of its handle is over, by whatever it was moved: mouse, keys or wheel.
/// The wheel moves it only while it has the focus, so that a panel scrolls beneath the mouse.
class ValueSlider : public QSlider {
    Q_OBJECT

public:
    explicit ValueSlider(QWidget* parent = nullptr);

signals:
    /// The handle was let go, the focus left, or nothing moved for a moment: what follows is another edit.
    void gestureFinished();

protected:
    void wheelEvent(QWheelEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void finish();

    QTimer m_pause;
};

} // namespace esm

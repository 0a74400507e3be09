#pragma once

#include "core/render/camera.h"

#include <QMouseEvent>
#include <QSize>
#include <QWheelEvent>

namespace esm {

/// How far the wheel was turned: positive away from the user.
double wheelNotches(const QWheelEvent& event);
/// How much nearer what is looked at comes by so many notches: as many back lead to where one was.
double zoomFactor(double notches);

/// Turns the mouse into cameras. The right button, or the left one with Alt, orbits; the middle button,
/// or either of those with Shift, shifts.
class CameraController {
public:
    const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera) { m_camera = camera; }

    /// Starts a drag when button and modifier keys ask for one; false leaves the press to the tool in hand.
    bool press(const QMouseEvent& event);
    /// Starts to orbit with whatever button was pressed.
    void startOrbit(const QMouseEvent& event) { start(Drag::Orbit, event); }
    /// Follows a drag that was started; false when there is none.
    bool move(const QMouseEvent& event, const QSize& viewSize);
    /// Ends a drag; false when there was none.
    bool release(const QMouseEvent& event);
    /// Whether what would orbit turns the line of sight where the eye stands.
    void setLookingAround(bool on) { m_looksAround = on; }

    bool isDragging() const { return m_drag != Drag::None; }

private:
    enum class Drag { None, Orbit, Pan };

    void start(Drag drag, const QMouseEvent& event);

    Camera m_camera;
    bool m_looksAround = false;
    Drag m_drag = Drag::None;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_last;
};

} // namespace esm

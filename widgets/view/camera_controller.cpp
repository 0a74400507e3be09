#include "widgets/view/camera_controller.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

constexpr double radiansPerHeight = 3.2; // a drag over the view's height turns about half round

} // namespace

double wheelNotches(const QWheelEvent& event) {
    constexpr double anglePerNotch = 120; // in eighths of a degree, as Qt counts
    return event.angleDelta().y() / anglePerNotch;
}

/// A power, so that parts of notches, as touchpads send them, add up the same way.
double zoomFactor(double notches) {
    constexpr double factorPerNotch = 0.87;
    return std::pow(factorPerNotch, notches);
}

bool CameraController::press(const QMouseEvent& event) {
    if (isDragging()) return true;
    const bool orbits = event.button() == Qt::RightButton ||
                        (event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::AltModifier));
    const bool pans = event.button() == Qt::MiddleButton ||
                      (orbits && event.modifiers().testFlag(Qt::ShiftModifier)) ||
                      (event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::ShiftModifier));
    if (!orbits && !pans) return false;
    start(pans ? Drag::Pan : Drag::Orbit, event);
    return true;
}

void CameraController::start(Drag drag, const QMouseEvent& event) {
    m_drag = drag;
    m_button = event.button();
    m_last = event.localPos();
}

bool CameraController::move(const QMouseEvent& event, const QSize& viewSize) {
    if (!isDragging()) return false;
    const QPointF by = (event.localPos() - m_last) / std::max(1, viewSize.height());
    m_last = event.localPos();
    // The organ follows the mouse, so the eye goes the other way.
    if (m_drag == Drag::Orbit && m_looksAround)
        m_camera = lookingAround(m_camera, -m_camera.verticalFieldOfView * by.x(),
                                 m_camera.verticalFieldOfView * by.y());
    else if (m_drag == Drag::Orbit)
        m_camera = orbited(m_camera, -radiansPerHeight * by.x(), radiansPerHeight * by.y());
    else
        m_camera = panned(m_camera, -by.x(), by.y());
    return true;
}

bool CameraController::release(const QMouseEvent& event) {
    if (!isDragging()) return false;
    if (event.button() == m_button) m_drag = Drag::None;
    return true;
}

} // namespace esm

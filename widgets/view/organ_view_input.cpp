#include "widgets/view/approach.h"
#include "widgets/view/axis_cube.h"
#include "widgets/view/organ_view.h"

#include <QTabletEvent>

namespace esm {
namespace {

constexpr double clickReach = 4; // pixels a click may wander before it is a drag

} // namespace

/// Who gets a press: the cube in the corner, a tool that asks for Shift, the camera, the tool; and where the
/// tool holds nothing, the left button turns the view. Until the pointer has wandered it may still become a
/// click, which is why nothing turns at first.
void OrganView::mousePressEvent(QMouseEvent* event) {
    const bool isFree = event->button() == Qt::LeftButton && !m_cameraController.isDragging();
    if (isFree) {
        const auto face = viewAt(event->localPos(), camera(), cubeSquare(size()));
        if (face) return showView(*face);
    }
    if (m_hold != Hold::Nothing) return;
    const ToolMouse mouse = mouseOf(*event);
    const bool isShift = isFree && event->modifiers() == Qt::ShiftModifier && m_tool->takesShift(mouse);
    if ((!isShift && m_cameraController.press(*event)) || event->button() != Qt::LeftButton) return;
    m_hold = m_tool->press(mouse);
    m_pressed.reset();
    if (m_hold != Hold::Stroke) m_pressed = event->localPos();
    if (m_hold == Hold::Nothing) m_cameraController.startOrbit(*event);
}

void OrganView::mouseMoveEvent(QMouseEvent* event) {
    if (m_pressed && distance(*m_pressed, event->localPos()) > clickReach) m_pressed.reset();
    if (m_hold == Hold::Nothing && m_cameraController.isDragging()) {
        if (m_pressed) return;
        m_cameraController.move(*event, size());
        return applyCamera(camera());
    }
    if (m_hold == Hold::Nothing || !m_pressed) moveTool(mouseOf(*event));
}

void OrganView::mouseReleaseEvent(QMouseEvent* event) {
    const bool wasClick = m_pressed && event->button() == Qt::LeftButton;
    m_pressed.reset();
    if (event->button() == Qt::LeftButton) letGo();
    m_cameraController.release(*event);
    if (wasClick) m_tool->click(mouseOf(*event));
    m_pressure.reset(); // a pen that is taken out of reach sends no release of its own
}

/// Only the pressure is kept: of an event that is not accepted Qt makes one of the mouse, at the same place
/// and next, so that a pen does all that the mouse does.
void OrganView::tabletEvent(QTabletEvent* event) {
    const bool isDown = event->type() != QEvent::TabletRelease && event->buttons() != Qt::NoButton;
    m_pressure = isDown ? std::optional(event->pressure()) : std::nullopt;
    event->ignore();
}

void OrganView::wheelEvent(QWheelEvent* event) {
    if (m_tool->wheel({sight(), event->position(), event->modifiers()}, wheelNotches(*event))) return;
    applyCamera(approached(sight(), event->position(), zoomFactor(wheelNotches(*event))));
}

void OrganView::keyPressEvent(QKeyEvent* event) {
    if (m_keyPointer.press(*event)) return;
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    cancel();
}

bool OrganView::focusNextPrevChild(bool next) {
    return m_keyPointer.goToNextStop(next) || QWidget::focusNextPrevChild(next);
}

void OrganView::leaveEvent(QEvent* event) {
    m_tool->leave();
    QWidget::leaveEvent(event);
}

ToolMouse OrganView::mouseOf(const QMouseEvent& event) {
    return {sight(), event.localPos(), event.modifiers(), m_pressure};
}

void OrganView::moveTool(const ToolMouse& mouse) {
    m_tool->move(mouse);
    setCursor(m_tool->cursor());
}

} // namespace esm

#include "widgets/texture/mask_tools.h"

#include "core/texture/photo/outline_cover.h"
#include "widgets/texture/photo_canvas.h"

#include <algorithm>

namespace esm {

namespace {

constexpr double outlineMargin = 0.5; ///< photo pixels: an outline leaves out the pixels it runs over

bool asksToTakeBack(const QMouseEvent& event) {
    return event.modifiers().testFlag(Qt::ControlModifier);
}

PhotoStroke outline(std::vector<Eigen::Vector2d> path, bool takesBack) {
    return {std::move(path), outlineMargin, 0, takesBack, true};
}

} // namespace

void MaskTool::release() {
    if (!m_stroke) return;
    const PhotoStroke stroke = *m_stroke;
    m_stroke.reset();
    m_canvas.addStroke(stroke);
}

bool MaskTool::drop() {
    const bool isDrawing = m_stroke.has_value();
    m_stroke.reset();
    return isDrawing;
}

void MaskTool::paint(QPainter& painter) const {
    if (!m_stroke || m_stroke->takesBack) return;
    painter.setOpacity(0.6);
    m_canvas.drawStroke(painter, *m_stroke);
    painter.setOpacity(1);
}

void MaskBrush::press(const QMouseEvent& event) {
    const auto [radius, softness] = m_canvas.brush();
    m_stroke = PhotoStroke{
        {m_canvas.toPhoto(event.localPos())}, radius, softness, m_takesBack || asksToTakeBack(event)};
}

/// Places nearer to each other than an eighth of the brush draw the same.
void MaskBrush::drag(const QMouseEvent& event) {
    const Eigen::Vector2d place = m_canvas.toPhoto(event.localPos());
    const double nearest = std::max(1.0, m_canvas.brush().radius / 8);
    if (m_stroke && (place - m_stroke->path.back()).norm() >= nearest) m_stroke->path.push_back(place);
}

void MaskBrush::paintCursor(QPainter& painter, const QPointF& mouse) const {
    const double radius = m_canvas.brush().radius * m_canvas.magnification();
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, by] : {std::pair(QColor(Qt::black), 1.0), {QColor(Qt::white), 0.0}}) {
        painter.setPen(QPen(colour, 1));
        painter.drawEllipse(mouse, radius + by, radius + by);
    }
}

void MaskOutline::press(const QMouseEvent& event) {
    m_stroke = outline({m_canvas.toPhoto(event.localPos())}, asksToTakeBack(event));
}

void MaskOutline::drag(const QMouseEvent& event) {
    const Eigen::Vector2d place = m_canvas.toPhoto(event.localPos());
    if (m_stroke && (place - m_stroke->path.back()).norm() * m_canvas.magnification() >= 2)
        m_stroke->path.push_back(place);
}

/// A click goes around nothing.
void MaskOutline::release() {
    if (m_stroke) m_stroke->path = simplified(m_stroke->path, 1 / m_canvas.magnification());
    if (m_stroke && m_stroke->path.size() < 3) m_stroke.reset();
    MaskTool::release();
}

void MaskBox::press(const QMouseEvent& event) {
    const Eigen::Vector2d corner = m_canvas.toPhoto(event.localPos());
    m_stroke = outline({corner, corner, corner, corner}, asksToTakeBack(event));
}

void MaskBox::drag(const QMouseEvent& event) {
    if (!m_stroke) return;
    auto& path = m_stroke->path;
    path[2] = m_canvas.toPhoto(event.localPos());
    path[1] = {path[2].x(), path[0].y()};
    path[3] = {path[0].x(), path[2].y()};
}

void MaskBox::release() {
    if (m_stroke && (m_stroke->path[2] - m_stroke->path[0]).cwiseAbs().minCoeff() < 1) m_stroke.reset();
    MaskTool::release();
}

void PlacePicker::press(const QMouseEvent& event) {
    emit m_canvas.placePicked(m_canvas.toPhoto(event.localPos()));
}

} // namespace esm

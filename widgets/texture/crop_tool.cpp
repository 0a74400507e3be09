#include "widgets/texture/crop_tool.h"

#include "widgets/texture/photo_canvas.h"

#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace esm {

namespace {

std::array<Eigen::Vector2d, 4> cornersOf(const PhotoCrop& crop) {
    const double left = crop.x, top = crop.y, right = left + crop.width, bottom = top + crop.height;
    return {Eigen::Vector2d(left, top), Eigen::Vector2d(right, top), Eigen::Vector2d(right, bottom),
            Eigen::Vector2d(left, bottom)};
}

} // namespace

void CropTool::press(const QMouseEvent& event) {
    const QPointF at = event.localPos();
    m_before = m_canvas.crop();
    m_fixed = m_canvas.toPhoto(at);
    if (!m_before) return;
    const auto corners = cornersOf(*m_before);
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (m_canvas.isAt(corners[i], at)) m_fixed = corners[(i + 2) % corners.size()];
}

void CropTool::drag(const QMouseEvent& event) {
    if (!m_fixed) return;
    const QSize size = m_canvas.photoSize();
    const auto within = [](double place, int most) {
        return static_cast<int>(std::lround(std::clamp(place, 0.0, static_cast<double>(most))));
    };
    const Eigen::Vector2d to = m_canvas.toPhoto(event.localPos());
    const Eigen::Vector2d low = m_fixed->cwiseMin(to), high = m_fixed->cwiseMax(to);
    const int left = within(low.x(), size.width()), right = within(high.x(), size.width());
    const int top = within(low.y(), size.height()), bottom = within(high.y(), size.height());
    if (right - left < 2 || bottom - top < 2) return;
    m_canvas.setCrop(PhotoCrop{left, top, right - left, bottom - top});
    emit m_canvas.cropDrawn(*m_canvas.crop());
}

void CropTool::release() {
    if (!m_fixed) return;
    m_fixed.reset();
    emit m_canvas.shapeFinished();
}

bool CropTool::drop() {
    if (!m_fixed) return false;
    m_fixed.reset();
    emit m_canvas.cropDropped(m_before);
    return true;
}

void CropTool::paint(QPainter& painter) const {
    if (!m_canvas.crop()) return;
    const auto corners = cornersOf(*m_canvas.crop());
    QPainterPath inside;
    inside.addRect(QRectF(m_canvas.toWidget(corners[0]), m_canvas.toWidget(corners[2])));
    m_canvas.drawKept(painter, inside);
    for (const Eigen::Vector2d& corner : corners)
        m_canvas.drawHandle(painter, corner);
}

} // namespace esm

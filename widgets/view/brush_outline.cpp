#include "widgets/view/brush_outline.h"

#include "core/support/angles.h"

#include <Eigen/Geometry>

#include <cmath>

namespace esm {

namespace {

/// Seen on dark and on light tissue alike.
template<typename Draw> void drawTwice(QPainter& painter, double width, const Draw& draw) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), width + 2));
    draw();
    painter.setPen(QPen(Qt::white, width));
    draw();
}

} // namespace

/// In space and not in the picture: seen aslant it becomes the ellipse that is painted.
std::vector<Eigen::Vector3d> circleAround(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                          double radius) {
    constexpr int corners = 48;
    const Eigen::Vector3d across = normal.unitOrthogonal(), along = normal.normalized().cross(across);
    std::vector<Eigen::Vector3d> circle;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        circle.emplace_back(point + radius * (std::cos(angle) * across + std::sin(angle) * along));
    }
    return circle;
}

void paintBrush(QPainter& painter, const QPolygonF& rim, const QPolygonF& core) {
    painter.save();
    drawTwice(painter, 1.4, [&] { painter.drawPolygon(rim); });
    painter.setPen(QPen(QColor(255, 255, 255, 120), 1, Qt::DotLine));
    painter.drawPolygon(core);
    painter.restore();
}

void paintSource(QPainter& painter, const QPointF& place) {
    constexpr double arm = 7; // pixels
    painter.save();
    drawTwice(painter, 1.6, [&] {
        painter.drawLine(place - QPointF(arm, 0), place + QPointF(arm, 0));
        painter.drawLine(place - QPointF(0, arm), place + QPointF(0, arm));
    });
    painter.restore();
}

} // namespace esm

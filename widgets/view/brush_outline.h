#pragma once

#include <Eigen/Core>

#include <QPainter>
#include <QPolygonF>

#include <optional>
#include <vector>

namespace esm {

/// The brush in the user's hand, as the view shows it.
struct ViewBrush {
    double radius = 0.005;                 ///< m
    double softness = 0.5;                 ///< share of the radius over which it fades, 0 to 1
    std::optional<Eigen::Vector3d> source; ///< m, on the organ at rest: where a clone brush takes its colours
};

/// A circle around a point of a surface with that normal, m.
std::vector<Eigen::Vector3d> circleAround(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                          double radius);

/// The brush's rim, and inside it where it begins to fade.
void paintBrush(QPainter& painter, const QPolygonF& rim, const QPolygonF& core);
/// A cross where a clone brush takes its colours.
void paintSource(QPainter& painter, const QPointF& place);

} // namespace esm

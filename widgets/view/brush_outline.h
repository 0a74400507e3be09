#pragma once

#include <Eigen/Core>

#include <QPainter>
#include <QPolygonF>

#include <vector>

namespace esm {

/// A circle around a point of a surface with that normal, m.
std::vector<Eigen::Vector3d> circleAround(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                          double radius);

/// The brush's rim, and inside it where it begins to fade.
void paintBrush(QPainter& painter, const QPolygonF& rim, const QPolygonF& core);
/// A cross where a clone brush takes its colours.
void paintSource(QPainter& painter, const QPointF& place);

} // namespace esm

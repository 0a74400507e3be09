#pragma once

#include "core/render/camera.h"

#include <QPainter>
#include <QPalette>
#include <QPolygonF>

#include <optional>
#include <vector>

namespace esm {

struct CubeFace {
    StandardView view; ///< from which the face is seen upright
    QPolygonF outline; ///< top left, top right, bottom right, bottom left of the face's text
    double facing;     ///< 1 when the face looks straight at the viewer, towards 0 at its edge
};

/// The faces of a small cube that stands in the organ's space, as the camera sees it in a square of the view.
std::vector<CubeFace> visibleFaces(const Camera& camera, const QRectF& square);

/// Faces that look at the viewer are painted as raised, the others darker.
void paintAxisCube(QPainter& painter, const Camera& camera, const QRectF& square, const QPalette& palette);

/// The view named on the face under a point.
std::optional<StandardView> viewAt(const QPointF& point, const Camera& camera, const QRectF& square);

} // namespace esm

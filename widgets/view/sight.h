#pragma once

#include "widgets/view/picking.h"

#include <QPolygonF>
#include <QSize>

#include <optional>

namespace esm {

/// What the user sees of the organ now: between places in the view (pixels) and points of space (m). Holds
/// references, so it is for the moment only.
struct Sight {
    const RenderScene& scene;
    const Camera& camera;
    QSize size;
    Picker& picker;

    double aspect() const;
    Ray rayAt(const QPointF& place) const;
    /// Nothing where the point lies behind the eye.
    std::optional<QPointF> placeOf(const Eigen::Vector3d& point) const;
    /// Without what lies behind the eye.
    QPolygonF placesOf(const std::vector<Eigen::Vector3d>& points) const;
    std::optional<PickedPoint> pickAt(const QPointF& place) const;
    /// Where the mouse is in the picture, as in `pickRay`.
    Eigen::Vector2d shareOf(const QPointF& place) const;
    /// The size of a pixel at a point, m.
    double pixelAt(const Eigen::Vector3d& point) const;
    /// Whether surface lies before a point.
    bool hides(const Eigen::Vector3d& point) const;
};

/// What is seen nearest to the middle of the view; nothing where no organ is in sight.
std::optional<PickedPoint> pickNearMiddle(const Sight& sight);

/// Between two places, pixels.
double distance(const QPointF& a, const QPointF& b);

} // namespace esm

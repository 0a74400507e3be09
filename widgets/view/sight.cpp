#include "widgets/view/sight.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double nodeReach = 12; // pixels around a node that is picked without a surface

} // namespace

double Sight::aspect() const {
    return static_cast<double>(std::max(1, size.width())) / std::max(1, size.height());
}

Ray Sight::rayAt(const QPointF& place) const {
    return pickRay(camera, place.x() / std::max(1, size.width()), place.y() / std::max(1, size.height()),
                   aspect());
}

std::optional<QPointF> Sight::placeOf(const Eigen::Vector3d& point) const {
    const std::optional<Eigen::Vector2d> place = picturePoint(camera, point, aspect());
    if (!place) return std::nullopt;
    return QPointF(place->x() * size.width(), place->y() * size.height());
}

QPolygonF Sight::placesOf(const std::vector<Eigen::Vector3d>& points) const {
    QPolygonF polygon;
    for (const Eigen::Vector3d& point : points)
        if (const auto place = placeOf(point)) polygon << *place;
    return polygon;
}

std::optional<PickedPoint> Sight::pickAt(const QPointF& place) const {
    return picker.pick(scene, rayAt(place), nodeReach / size.height() * camera.verticalFieldOfView);
}

/// Depth along the line of sight, not the distance from the eye: in a flat picture all at one depth have one
/// scale.
double Sight::pixelAt(const Eigen::Vector3d& point) const {
    const double depth = (camera.eye - point).dot(cameraAxes(camera).col(2));
    return 2 * std::tan(camera.verticalFieldOfView / 2) * depth / std::max(1, size.height());
}

/// A point on the surface lies a rounding error before or behind it: a thousandth of the way is what counts
/// as before.
bool Sight::hides(const Eigen::Vector3d& point) const {
    constexpr double share = 1e-3; // of the way to the eye, by which the surface must lie nearer
    const double depth = (point - camera.eye).norm();
    const auto first = picker.pick(scene, {camera.eye, point - camera.eye}, 0);
    return first && (first->point - camera.eye).norm() < (1 - share) * depth;
}

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace esm

#include "widgets/view/sight.h"

#include <QtMath>

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

std::optional<PickedPoint> pickNearMiddle(const Sight& sight) {
    constexpr double step = 12; // pixels; a finer organ than that is not pointed at
    const QPointF middle(sight.size.width() / 2.0, sight.size.height() / 2.0);
    const double farthest = std::hypot(middle.x(), middle.y());
    for (double radius = 0; radius <= farthest; radius += step) {
        const int places = std::max(1, qCeil(2 * M_PI * radius / step));
        for (int i = 0; i < places; ++i) {
            const double angle = 2 * M_PI * i / places;
            if (const auto picked = sight.pickAt(middle + radius * QPointF(std::cos(angle), std::sin(angle))))
                return picked;
        }
    }
    return std::nullopt;
}

} // namespace esm

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
    const Eigen::Vector2d share = shareOf(place);
    return pickRay(camera, share.x(), share.y(), aspect());
}

Eigen::Vector2d Sight::shareOf(const QPointF& place) const {
    return {place.x() / std::max(1, size.width()), place.y() / std::max(1, size.height())};
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
    const Ray ray = rayAt(place);
    const double share = nodeReach / std::max(1, size.height());
    const PickReach reach =
        camera.orthographicHeight
            ? PickReach{share * *camera.orthographicHeight, 0}
            : PickReach{0, share * pictureHeightAt(camera, ray.origin - cameraAxes(camera).col(2))};
    return picker.pick(scene, ray, reach);
}

/// By depth along the line of sight, not the distance from the eye: in a flat picture all at one depth have
/// one scale.
double Sight::pixelAt(const Eigen::Vector3d& point) const {
    return pictureHeightAt(camera, point) / std::max(1, size.height());
}

/// A point on the surface lies a rounding error before or behind it: a thousandth of the way is what counts
/// as before.
bool Sight::hides(const Eigen::Vector3d& point) const {
    constexpr double share = 1e-3; // of the way to the viewer, by which the surface must lie nearer
    const Eigen::Vector3d backwards = cameraAxes(camera).col(2);
    const Eigen::Vector3d viewer =
        camera.orthographicHeight ? Eigen::Vector3d(point + (camera.eye - point).dot(backwards) * backwards)
                                  : camera.eye;
    const double way = (point - viewer).norm();
    const auto first = picker.pick(scene, {viewer, point - viewer});
    return first && (first->point - viewer).norm() < (1 - share) * way;
}

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

std::optional<PickedPoint> pickNearMiddle(const Sight& sight) {
    constexpr double step = 12; // pixels; a finer organ than that is not pointed at
    const QPointF middle(sight.size.width() / 2.0, sight.size.height() / 2.0);
    const double farthest = std::hypot(middle.x(), middle.y());
    for (int ring = 0; ring * step <= farthest; ++ring) {
        const double radius = ring * step;
        const int places = std::max(1, qCeil(2 * M_PI * radius / step));
        for (int i = 0; i < places; ++i) {
            const double angle = 2 * M_PI * i / places;
            if (auto picked = sight.pickAt(middle + radius * QPointF(std::cos(angle), std::sin(angle))))
                return picked;
        }
    }
    return std::nullopt;
}

} // namespace esm

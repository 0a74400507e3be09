#include "widgets/view/within.h"

#include <utility>
#include <vector>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double fieldWithin = 1.4; // rad, as endoscopes have
constexpr int mostWalls = 64;

/// Between two walls that a ray meets one after the other.
struct Room {
    Vector3d middle; ///< m
    double length;   ///< m
};

Ray sightLine(const Sight& sight, const std::optional<Vector3d>& about) {
    const Ray middle = sight.rayAt(QPointF(sight.size.width(), sight.size.height()) / 2);
    if (!about) return middle;
    const Vector3d direction = -towardsViewer(sight.camera, *about);
    if (!sight.camera.orthographicHeight) return {sight.camera.eye, direction};
    return {*about - (*about - sight.camera.eye).dot(direction) * direction, direction};
}

std::vector<Room> roomsAlong(const Sight& sight, Ray ray) {
    const double step = 1e-6 * boundingBox(sight.scene.mesh->vertices).diagonal().norm();
    std::vector<Room> rooms;
    std::optional<Vector3d> wall;
    for (int walls = 0; walls < mostWalls; ++walls) {
        const auto met = sight.picker.pick(sight.scene, ray);
        if (!met) break;
        if (wall) rooms.push_back({(*wall + met->point) / 2, (met->point - *wall).norm()});
        wall = met->point;
        ray.origin = met->point + step * ray.direction;
    }
    return rooms;
}

/// An open organ, as a colon cut at its ends, has one side without a wall.
bool isEnclosed(const Sight& sight, const Vector3d& place) {
    int walls = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            walls += sight.picker.pick(sight.scene, {place, side * Vector3d::Unit(axis)}) ? 1 : 0;
    return walls >= 5;
}

} // namespace

/// Tissue modelled with both its faces has thin rooms within its walls and a wide one, the cavity, between
/// them; between two loops of an organ there is room as well, but not on all sides.
std::optional<Camera> cameraWithin(const Sight& sight, const std::optional<Vector3d>& about) {
    if (!sight.scene.mesh || sight.scene.mesh->triangles.empty()) return std::nullopt;
    const Ray line = sightLine(sight, about);
    std::optional<std::pair<bool, Room>> best;
    for (const Room& room : roomsAlong(sight, line)) {
        const bool enclosed = isEnclosed(sight, room.middle);
        if (!best || std::pair(enclosed, room.length) > std::pair(best->first, best->second.length))
            best = {enclosed, room};
    }
    if (!best) return std::nullopt;
    Camera camera = sight.camera;
    camera.orthographicHeight.reset();
    camera.verticalFieldOfView = fieldWithin;
    camera.eye = best->second.middle;
    camera.target = best->second.middle + best->second.length / 2 * line.direction;
    return camera;
}

} // namespace esm

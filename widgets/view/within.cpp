#include "widgets/view/within.h"

#include "core/support/angles.h"

#include <cmath>
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
    Ray middle = sight.rayAt(QPointF(sight.size.width(), sight.size.height()) / 2);
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

/// Who looks straight at a wall sees nothing else, as across a vessel: where another way is much longer,
/// along it. Tried are directions spread evenly over a sphere (a spiral by the golden angle). Ways out of an
/// open end are none: there is nothing to see.
Vector3d outlook(const Sight& sight, const Vector3d& place, const Vector3d& wanted) {
    constexpr int tried = 200;
    constexpr double muchLonger = 2;
    const auto wayTo = [&](const Vector3d& direction) {
        const auto met = sight.picker.pick(sight.scene, {place, direction});
        return met ? (met->point - place).norm() : 0;
    };
    Vector3d best = wanted;
    double longest = muchLonger * wayTo(wanted);
    for (int i = 0; i < tried; ++i) {
        const double height = 1 - (2 * i + 1.0) / tried, around = i * pi * (3 - std::sqrt(5.0));
        const double aside = std::sqrt(1 - height * height);
        const Vector3d direction(aside * std::cos(around), height, aside * std::sin(around));
        const double way = wayTo(direction);
        if (way <= longest) continue;
        longest = way;
        best = direction;
    }
    return best;
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
    camera.target = camera.eye + best->second.length / 2 * outlook(sight, camera.eye, line.direction);
    return camera;
}

} // namespace esm

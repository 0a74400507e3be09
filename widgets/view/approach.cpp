#include "widgets/view/approach.h"

#include <algorithm>

namespace esm {
namespace {

using Eigen::Vector3d;

constexpr double gapShare = 0.004; // of the organ's size, which a near plane leaves whole

bool hasSurface(const RenderScene& scene) {
    return scene.mesh && !scene.mesh->triangles.empty();
}

double gapOf(const RenderScene& scene) {
    return gapShare * boundingBox(scene.mesh->vertices).diagonal().norm();
}

/// The part of the way from the eye to a point on which nothing is met. The first surface on the way is
/// stopped before; what stands beside the way may come no nearer than the gap, of which the last clear place
/// is found by halving.
double openShare(const Sight& sight, const Vector3d& to) {
    const Vector3d from = sight.camera.eye, way = to - from;
    const auto clearance = [&](const Vector3d& place) {
        return sight.picker.clearance(sight.scene, place).value_or(HUGE_VAL);
    };
    const double gap = gapOf(sight.scene), kept = std::min(gap, (1 - 1e-9) * clearance(from));
    double open = 1;
    if (const auto met = sight.picker.pick(sight.scene, {from, way}))
        open = std::clamp(((met->point - from).norm() - gap) / way.norm(), 0.0, 1.0);
    if (clearance(from + open * way) >= kept) return open;
    double clear = 0;
    for (int halving = 0; halving < 20; ++halving) {
        const double middle = (clear + open) / 2;
        (clearance(from + middle * way) >= kept ? clear : open) = middle;
    }
    return clear;
}

} // namespace

/// Towards the very point under the mouse the way is free up to it, and each notch takes the same share of
/// what is left. Beside the organ the target's depth stands in for it.
Camera approached(const Sight& sight, const QPointF& place, double factor) {
    const auto picked = hasSurface(sight.scene) ? sight.pickAt(place) : std::nullopt;
    const auto scaled = [&](double by) {
        return picked ? scaledAbout(sight.camera, by, picked->point)
                      : zoomedAbout(sight.camera, by, sight.shareOf(place), sight.aspect());
    };
    Camera wanted = scaled(factor);
    if (sight.camera.orthographicHeight || !hasSurface(sight.scene)) return wanted;
    const double open = openShare(sight, wanted.eye);
    return open < 1 ? scaled(1 - open * (1 - factor)) : wanted;
}

/// A surface that is met from its back while going backwards is left through it. Organs have few walls one
/// behind the other.
Camera outOfSurface(const Sight& sight) {
    Camera camera = sight.camera;
    if (camera.orthographicHeight || !hasSurface(sight.scene)) return camera;
    const Vector3d backwards = cameraAxes(camera).col(2);
    for (int walls = 0; walls < 16; ++walls) {
        const auto met = sight.picker.pick(sight.scene, {camera.eye, backwards});
        if (!met || met->spot.outward.dot(met->normal) > 0) break;
        camera.eye = met->point + gapOf(sight.scene) * backwards;
    }
    return camera;
}

} // namespace esm

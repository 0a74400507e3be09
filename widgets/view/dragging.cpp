#include "widgets/view/dragging.h"

#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

/// The selected shape wins over nearer ones: who drags what is selected must not take hold of what lies
/// before it.
/// @param distanceAlong the ray to a shape; none where it is missed
template<typename Drawn, typename Distance>
int shapeUnder(const std::vector<Drawn>& shapes, Distance distanceAlong) {
    int found = -1;
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const std::optional<double> distance = distanceAlong(shapes[i]);
        if (!distance) continue;
        if (shapes[i].selected) return static_cast<int>(i);
        if (*distance >= nearest) continue;
        nearest = *distance;
        found = static_cast<int>(i);
    }
    return found;
}

} // namespace

DragPlane picturePlane(const Camera& camera, const Vector3d& point) {
    return {point, cameraAxes(camera).col(2)};
}

Vector3d shift(const DragPlane& plane, const Ray& ray) {
    const std::optional<Vector3d> now = meet(ray, plane);
    return now ? Vector3d(*now - plane.point) : Vector3d(Vector3d::Zero());
}

int ellipsoidUnder(const RenderScene& scene, const Ray& ray) {
    return shapeUnder(scene.ellipsoids, [&](const DrawnEllipsoid& drawn) {
        const bool isCutAway = scene.cut && scene.cut->hides(drawn.shape.centre);
        return isCutAway ? std::nullopt : distanceTo(drawn.shape, ray);
    });
}

PhotoFace faceOf(const DrawnProjector& drawn) {
    return {drawn.projector, drawn.size(), drawn.depth};
}

int projectorUnder(const RenderScene& scene, const Ray& ray) {
    return shapeUnder(scene.projectors,
                      [&](const DrawnProjector& drawn) { return distanceTo(faceOf(drawn), ray); });
}

} // namespace esm

#include "widgets/view/dragging.h"

#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

/// The selected shape wins over nearer ones: who drags what is selected must not take hold of what lies
/// before it.
template<typename Drawn, typename ShapeOf>
int shapeUnder(const std::vector<Drawn>& shapes, ShapeOf shapeOf, const Ray& ray) {
    int found = -1;
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const std::optional<double> distance = distanceTo(shapeOf(shapes[i]), ray);
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
    return shapeUnder(
        scene.ellipsoids, [](const DrawnEllipsoid& drawn) { return drawn.shape; }, ray);
}

PhotoFace faceOf(const DrawnProjector& drawn) {
    return {drawn.projector, drawn.size(), drawn.depth};
}

int projectorUnder(const RenderScene& scene, const Ray& ray) {
    return shapeUnder(scene.projectors, faceOf, ray);
}

} // namespace esm

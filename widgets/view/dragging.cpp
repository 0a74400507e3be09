#include "widgets/view/dragging.h"

#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

/// How far the mouse went since the drag began; the plane goes through the place where it began.
Vector3d shift(const DragPlane& plane, const Ray& ray) {
    const std::optional<Vector3d> now = meet(ray, plane);
    return now ? Vector3d(*now - plane.point) : Vector3d(Vector3d::Zero());
}

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

std::optional<Vector3d> target(const PullDrag& drag, const Ray& ray) {
    const std::optional<Vector3d> point = meet(ray, drag.plane);
    if (!point) return std::nullopt;
    return *point + drag.nodeOffset;
}

Ellipsoid dragged(const RegionMove& drag, const Ray& ray) {
    Ellipsoid moved = drag.start;
    moved.centre += shift(drag.plane, ray);
    return moved;
}

Ellipsoid dragged(const RegionScale& drag, const Ray& ray) {
    return scaled(drag.start, drag.handle, ray);
}

Ellipsoid dragged(const RegionTurn& drag, const Ray& ray) {
    return turned(drag.start, drag.grip, ray);
}

std::optional<double> dragged(const RimSize& drag, const Ray& ray) {
    const std::optional<Vector3d> point = meet(ray, drag.plane);
    if (!point) return std::nullopt;
    return distanceOutside(drag.shape, *point);
}

Projector dragged(const ProjectorMove& drag, const Ray& ray) {
    Projector moved = drag.start;
    moved.pose.pretranslate(shift(drag.plane, ray));
    return moved;
}

Projector dragged(const ProjectorScale& drag, const Ray& ray, Proportions proportions) {
    return scaled(drag.start, drag.handle, ray, proportions);
}

DragPlane picturePlane(const Camera& camera, const Vector3d& point) {
    return {point, cameraAxes(camera).col(2)};
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

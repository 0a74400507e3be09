#pragma once

#include "core/render/renderer.h"
#include "widgets/view/gizmos.h"

namespace esm {

/// A drag is computed from where it began, so that it ends where the mouse is, however often the scene was
/// replaced meanwhile.

/// A plane parallel to the picture.
DragPlane picturePlane(const Camera& camera, const Eigen::Vector3d& point);
/// How far the mouse went in a plane that goes through the place where the drag began, m; zero where the ray
/// misses it.
Eigen::Vector3d shift(const DragPlane& plane, const Ray& ray);

/// The ellipsoid under a ray, the selected one first, else the nearest; −1 for none. One whose middle is cut
/// away is none.
int ellipsoidUnder(const RenderScene& scene, const Ray& ray);
PhotoFace faceOf(const DrawnProjector& drawn);
/// The same for the projectors' photos.
int projectorUnder(const RenderScene& scene, const Ray& ray);

/// The one that is selected, null without.
template<typename Drawn> const Drawn* selectedOf(const std::vector<Drawn>& shapes) {
    for (const Drawn& drawn : shapes)
        if (drawn.selected) return &drawn;
    return nullptr;
}

} // namespace esm

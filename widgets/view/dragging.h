#pragma once

#include "core/render/renderer.h"
#include "widgets/view/region_handles.h"

#include <variant>

namespace esm {

/// What a pressed left button holds, as it was when it was pressed: a drag is computed from its start, so
/// that it ends where the mouse is, however often the scene was replaced meanwhile.
struct PullDrag {
    std::uint32_t node;
    DragPlane plane;            ///< through the picked point, parallel to the picture
    Eigen::Vector3d nodeOffset; ///< from the picked point to the node, m
};
struct RegionMove {
    int index;
    Ellipsoid start;
    DragPlane plane;
};
struct RegionScale {
    int index;
    Ellipsoid start;
    std::size_t handle;
};
struct RegionTurn {
    int index;
    Ellipsoid start;
    Grip grip;
};
struct RimSize {
    int index;
    Ellipsoid shape;
    DragPlane plane;
};
struct ProjectorMove {
    int index;
    Projector start;
    DragPlane plane;
};
struct ProjectorScale {
    int index;
    PhotoFace start;
    std::size_t handle;
};
struct LandmarkMove {
    int number;
};
struct InstrumentSweep {
    DragPlane plane;
};
struct BrushMove {};
using Drag = std::variant<PullDrag, RegionMove, RegionScale, RegionTurn, RimSize, ProjectorMove,
                          ProjectorScale, LandmarkMove, InstrumentSweep, BrushMove>;

/// Where the pulled node is to go, m; nothing where the ray misses the plane. The other functions give what
/// the drag makes of the shape it started with, which stays where the ray misses.
std::optional<Eigen::Vector3d> target(const PullDrag& drag, const Ray& ray);
Ellipsoid dragged(const RegionMove& drag, const Ray& ray);
Ellipsoid dragged(const RegionScale& drag, const Ray& ray);
Ellipsoid dragged(const RegionTurn& drag, const Ray& ray);
Projector dragged(const ProjectorMove& drag, const Ray& ray);
Projector dragged(const ProjectorScale& drag, const Ray& ray, Proportions proportions);

/// The rim, m, whose outline goes through the mouse: none inside; nothing where the ray misses the plane.
std::optional<double> dragged(const RimSize& drag, const Ray& ray);

/// A plane parallel to the picture.
DragPlane picturePlane(const Camera& camera, const Eigen::Vector3d& point);

/// The ellipsoid under a ray, the selected one first, else the nearest; −1 for none.
int ellipsoidUnder(const RenderScene& scene, const Ray& ray);
PhotoFace faceOf(const DrawnProjector& drawn);
/// The same for the projectors' photos.
int projectorUnder(const RenderScene& scene, const Ray& ray);

} // namespace esm

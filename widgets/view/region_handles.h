#pragma once

#include "core/render/renderer.h"
#include "widgets/view/ball_turn.h"
#include "widgets/view/gizmos.h"

#include <vector>

namespace esm {

/// What can be taken hold of at a region.
struct RegionHandle {
    enum class Kind {
        Size, ///< an end of the ellipsoid's axes
        Turn, ///< beyond an axis' positive end
        Rim   ///< on the outline of the soft rim
    };
    Kind kind;
    std::size_t end;       ///< counts as in `handles`; of a rim 0
    Eigen::Vector3d place; ///< m
    Eigen::Vector3d root;  ///< m, what it belongs to: of a turning handle the axis' end, else its own place
};

/// The handles of a region as seen by a camera, none of an axis that points at the viewer. The rim's stands
/// at the upper right, where it is farthest from the others.
/// @param turnReach how far the turning handles stand off the ends, m
std::vector<RegionHandle> regionHandles(const DrawnEllipsoid& region, const Camera& camera, double turnReach);

/// The ellipsoid turned about its centre: see ballTurn().
Ellipsoid turned(const Ellipsoid& ellipsoid, const Grip& grip, const Ray& ray);

} // namespace esm

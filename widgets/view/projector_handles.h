#pragma once

#include "core/render/camera.h"
#include "widgets/view/ball_turn.h"
#include "widgets/view/gizmos.h"

#include <vector>

namespace esm {

/// What can be taken hold of at a projector.
struct ProjectorHandle {
    enum class Kind {
        Size, ///< a corner or the middle of an edge of its photo
        Roll, ///< above the photo
        Turn, ///< below the photo
        Push  ///< before the photo, on the line of sight through its middle
    };
    Kind kind;
    std::size_t place;    ///< of a size, counts as in `handles`; of others 0
    Eigen::Vector3d at;   ///< m
    Eigen::Vector3d root; ///< m, the place of the photo that it hangs on; of a size its own
};

/// The handles as seen by a camera: none to push along a line that points at the viewer, none to roll a photo
/// that is seen from its edge.
/// @param reach how far those beside the photo stand off, m
std::vector<ProjectorHandle> projectorHandles(const PhotoFace& photo, const Camera& camera, double reach);

/// The line on which the middle of the photo is projected: from the eye, or from the photo's plane.
Ray photoSight(const PhotoFace& photo);

/// Turned about a point of space, m.
Projector turnedAbout(const Projector& projector, const Eigen::Vector3d& point,
                      const Eigen::Quaterniond& turn);

/// A projector and what it looks at while it is turned.
struct ProjectorTurn {
    PhotoFace photo;
    Eigen::Vector3d target; ///< m
    bool aboutItself;       ///< its place stays, else the target
    bool inSteps;           ///< of 15°, about its own x or y axis alone
};
/// The photo's middle follows the mouse around the target, or the target around the projector's place. The
/// grip is what follows: see turnedPlace().
Projector turned(const ProjectorTurn& what, const Ray& grip, const Ray& ray);
/// The place, m, that a ray has to go through to grip it.
Eigen::Vector3d turnedPlace(const ProjectorTurn& what);

/// Rolled about its line of sight by the angle between where two rays meet the photo's plane.
Projector rolled(const PhotoFace& photo, const Ray& from, const Ray& to, bool inSteps);

/// Pushed along its line of sight as far as from the one ray to the other; a perspective projector never
/// comes to what it looks at (m).
Projector pushed(const PhotoFace& photo, const Eigen::Vector3d& target, const Ray& from, const Ray& to);
/// The same by a share of the way to what it looks at: below 0 away from it.
Projector pushedBy(const PhotoFace& photo, const Eigen::Vector3d& target, double share);

/// Between two projectors, degrees.
double turnBetween(const Projector& a, const Projector& b);

} // namespace esm

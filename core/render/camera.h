#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/projection/projector.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace esm {

/// A perspective camera. Values only; orbit, pan and zoom make a new one.
struct Camera {
    Eigen::Vector3d eye{0, 0, 1};     ///< m
    Eigen::Vector3d target{0, 0, 0};  ///< m
    Eigen::Vector3d up{0, 1, 0};      ///< need not be at a right angle to the line of sight
    double verticalFieldOfView = 0.6; ///< rad
    double stretch = 1;               ///< how much wider than high a square is drawn
    Eigen::Vector2d centre{0.5, 0.5}; ///< where in the picture the line of sight ends, as in `pickRay`
};

/// The eye of a perspective projector, for pictures of its photo's aspect: they show what it projects.
Camera cameraOf(const Projector& projector, PhotoSize photo);

/// Standard views: front looks along −z (the eye at +z), right from +x, top from +y.
enum class StandardView { Front, Back, Left, Right, Top, Bottom };
/// "front", "back", "left", "right", "top" or "bottom".
std::optional<StandardView> standardViewFromName(const std::string& name);

/// A standard view that shows the whole box at the given aspect ratio (width over height). A box without size
/// or without any point is shown as one of 1 cm.
Camera framedCamera(const Eigen::AlignedBox3d& box, StandardView view, double aspect);
/// The same line of sight, moved so that the whole box is seen.
Camera reframed(const Camera& camera, const Eigen::AlignedBox3d& box, double aspect);

/// Carries the eye about the target by angles in rad: to the right about the vertical (y) axis, upwards about
/// the camera's x axis, at most until it looks straight down or up.
Camera orbited(const Camera& camera, double right, double upwards);
/// Shifts eye and target in the picture plane by fractions of the picture's height at the target's distance.
Camera panned(const Camera& camera, double right, double upwards);
/// Moves the eye towards the target; factor < 1 comes closer. The distance stays between 10 µm and 1 km.
Camera zoomed(const Camera& camera, double factor);
/// The same, with the point of the picture at x, y (see `pickRay`) staying where it is.
Camera zoomedAbout(const Camera& camera, double factor, const Eigen::Vector2d& point, double aspect);

/// The picture's axes in space: columns right, up and towards the viewer; a rotation also where `up` is
/// unusable.
Eigen::Matrix3d cameraAxes(const Camera& camera);
Eigen::Matrix4d viewMatrix(const Camera& camera);
/// OpenGL clip space; near and far planes are chosen to hold `box`.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box);
/// Ray through a point of the picture, x and y from 0 (left, top) to 1. Its direction has length 1.
Ray pickRay(const Camera& camera, double x, double y, double aspect);
/// Where a point of space lies in the picture, as in `pickRay`; nothing for a point behind the eye.
std::optional<Eigen::Vector2d> picturePoint(const Camera& camera, const Eigen::Vector3d& point,
                                            double aspect);

} // namespace esm

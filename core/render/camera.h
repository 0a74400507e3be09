#pragma once

#include "core/geometry/surface_query.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace esm {

/// A perspective camera. Values only; orbit, pan and zoom make a new one.
struct Camera {
    Eigen::Vector3d eye{0, 0, 1}; ///< m
    Eigen::Vector3d target{0, 0, 0}; ///< m
    Eigen::Vector3d up{0, 1, 0};
    double verticalFieldOfView = 0.6; ///< rad
};

/// Standard views: front looks along −z (the eye at +z), right from +x, top from +y.
enum class StandardView { Front, Back, Left, Right, Top, Bottom };
std::optional<StandardView> standardViewFromName(const std::string& name);

/// A standard view that shows the whole box at the given aspect ratio (width over height).
Camera framedCamera(const Eigen::AlignedBox3d& box, StandardView view, double aspect);

/// Turns about the target by angles in rad: `right` about the up axis, `upwards` about the camera's x axis.
Camera orbited(const Camera& camera, double right, double upwards);
/// Shifts eye and target in the picture plane by fractions of the picture's height.
Camera panned(const Camera& camera, double right, double upwards);
/// Moves the eye towards the target; factor < 1 comes closer.
Camera zoomed(const Camera& camera, double factor);

Eigen::Matrix4d viewMatrix(const Camera& camera);
/// OpenGL clip space; near and far planes are chosen to hold `box`.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box);
/// Ray through a point of the picture, x and y from 0 (left, top) to 1.
Ray pickRay(const Camera& camera, double x, double y, double aspect);

} // namespace esm

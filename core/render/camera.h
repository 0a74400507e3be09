#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/projection/projector.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <string>

namespace esm {

/// A perspective or orthographic camera. Values only; orbit, pan and zoom make a new one.
struct Camera {
    Eigen::Vector3d eye{0, 0, 1};     ///< m
    Eigen::Vector3d target{0, 0, 0};  ///< m
    Eigen::Vector3d up{0, 1, 0};      ///< need not be at a right angle to the line of sight
    double verticalFieldOfView = 0.6; ///< rad, of a perspective camera
    /// m, what the picture is high at any depth: the camera is orthographic. None: it is perspective.
    std::optional<double> orthographicHeight{};
    double stretch = 1;               ///< how much wider than high a square is drawn
    Eigen::Vector2d centre{0.5, 0.5}; ///< where in the picture the line of sight ends, as in `pickRay`

    bool operator==(const Camera&) const = default;
};

/// The eye of a perspective projector, for pictures of its photo's aspect: they show what it projects.
Camera cameraOf(const Projector& projector, PhotoSize photo);

/// Standard views: front looks along −z (the eye at +z), right from +x, top from +y.
enum class StandardView { Front, Back, Left, Right, Top, Bottom };
/// "front", "back", "left", "right", "top" or "bottom".
std::optional<StandardView> standardViewFromName(const std::string& name);

/// The box, or one of 1 cm in its place where it has no size, no point or none at a finite place.
Eigen::AlignedBox3d drawnBox(const Eigen::AlignedBox3d& box);
/// A standard view that shows the whole box at the given aspect ratio (width over height). `drawnBox`
/// says how large a box without size is.
Camera framedCamera(const Eigen::AlignedBox3d& box, StandardView view, double aspect);
/// The same line of sight, moved so that the whole box is seen.
Camera reframed(const Camera& camera, const Eigen::AlignedBox3d& box, double aspect);

/// The same framing without perspective, or with it: what lies at the target's depth keeps its size.
Camera orthographic(const Camera& camera);
Camera perspective(const Camera& camera);
/// An orthographic camera whose eye stands before the whole box, where it sees the same: rays from the
/// picture begin there. A perspective one stays.
Camera standingBefore(const Camera& camera, const Eigen::AlignedBox3d& box);

/// Carries the eye about the target by angles in rad: to the right about the vertical (y) axis, upwards about
/// the camera's x axis, at most until it looks straight down or up.
Camera orbited(const Camera& camera, double right, double upwards);
/// Turns the line of sight by angles in rad, to the right about the vertical and upwards as `orbited`, where
/// the eye stands.
Camera lookingAround(const Camera& camera, double right, double upwards);
/// Shifts eye and target in the picture plane by fractions of the picture's height at the target's distance.
Camera panned(const Camera& camera, double right, double upwards);
/// Moves the eye towards the target; factor < 1 comes closer. The distance stays between 10 µm and 1 km. An
/// orthographic camera shows so much less or more instead.
Camera zoomed(const Camera& camera, double factor);
/// The same, with the point of the picture at x, y (see `pickRay`) staying where it is.
Camera zoomedAbout(const Camera& camera, double factor, const Eigen::Vector2d& point, double aspect);
/// The same with a point of space (m): eye and target come as much closer to it.
Camera scaledAbout(const Camera& camera, double factor, const Eigen::Vector3d& point);

/// The picture's axes in space: columns right, up and towards the viewer; a rotation also where `up` is
/// unusable.
Eigen::Matrix3d cameraAxes(const Camera& camera);
/// What the picture is high at a point's depth, m; below 0 behind a perspective eye.
double pictureHeightAt(const Camera& camera, const Eigen::Vector3d& point);
/// From a point to the viewer, of length 1.
Eigen::Vector3d towardsViewer(const Camera& camera, const Eigen::Vector3d& point);
/// The eye; of an orthographic camera a point so far off that lines to it are parallel, to 10⁻⁶ of the
/// distances in a scene of this size (m).
Eigen::Vector3d viewpoint(const Camera& camera, double sceneSize);
Eigen::Matrix4d viewMatrix(const Camera& camera);
/// OpenGL clip space; near and far planes are chosen to hold `box`.
Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspect, const Eigen::AlignedBox3d& box);
/// Ray through a point of the picture, x and y from 0 (left, top) to 1, from the eye, of an orthographic
/// camera from the plane through it. Its direction has length 1.
Ray pickRay(const Camera& camera, double x, double y, double aspect);
/// Where a point of space lies in the picture, as in `pickRay`; nothing for a point behind a perspective eye.
std::optional<Eigen::Vector2d> picturePoint(const Camera& camera, const Eigen::Vector3d& point,
                                            double aspect);

} // namespace esm

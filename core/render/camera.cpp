#include "core/render/camera.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double smallestDistance = 1e-5;   // m
constexpr double largestDistance = 1e3;     // m
constexpr double smallestFramedSize = 0.01; // m
constexpr double framedShare = 0.88;        // of the picture's width or height

std::pair<Vector3d, Vector3d> directionAndUp(StandardView view) {
    switch (view) {
    case StandardView::Front:
        return {Vector3d::UnitZ(), Vector3d::UnitY()};
    case StandardView::Back:
        return {-Vector3d::UnitZ(), Vector3d::UnitY()};
    case StandardView::Left:
        return {-Vector3d::UnitX(), Vector3d::UnitY()};
    case StandardView::Right:
        return {Vector3d::UnitX(), Vector3d::UnitY()};
    case StandardView::Top:
        return {Vector3d::UnitY(), -Vector3d::UnitZ()};
    case StandardView::Bottom:
        return {-Vector3d::UnitY(), Vector3d::UnitZ()};
    }
    return {Vector3d::UnitZ(), Vector3d::UnitY()};
}

/// What a perspective camera shows at a distance, m.
double heightFrom(double distance, const Camera& camera) {
    return 2 * std::tan(camera.verticalFieldOfView / 2) * distance;
}

double heightWithin(double height, const Camera& camera) {
    return std::clamp(height, heightFrom(smallestDistance, camera), heightFrom(largestDistance, camera));
}

double pictureHeightAtTarget(const Camera& camera) {
    return pictureHeightAt(camera, camera.target);
}

/// First up or down about the camera's own sideways axis, then about the vertical of space, so that the
/// horizon stays level however long one turns. The limit is a quarter turn either way, straight from above
/// and below.
Matrix3d turnedAxes(const Camera& camera, double right, double upwards) {
    const Matrix3d axes = cameraAxes(camera);
    // The up direction never turns below the horizon: beyond it, "right" would turn the wrong way.
    const double elevation = std::atan2(axes.col(2).y(), axes.col(1).y());
    constexpr double limit = pi / 2;
    const double rise = std::clamp(elevation + upwards, -limit, limit) - elevation;
    const Eigen::AngleAxisd aboutVertical(right, Vector3d::UnitY());
    const Eigen::AngleAxisd aboutSideways(-rise, axes.col(0));
    return aboutVertical.toRotationMatrix() * aboutSideways.toRotationMatrix() * axes;
}

Vector3d corner(const AlignedBox3d& box, int index) {
    return box.corner(static_cast<AlignedBox3d::CornerType>(index));
}

} // namespace

/// An empty scene, a single point or a place that is not finite has no size to look at: a centimetre stands
/// in for it, so that every camera has a distance and every projection two planes.
AlignedBox3d drawnBox(const AlignedBox3d& box) {
    const bool usable = !box.isEmpty() && box.min().allFinite() && box.max().allFinite();
    if (usable && box.diagonal().norm() > smallestDistance) return box;
    const Vector3d centre = usable ? Vector3d(box.center()) : Vector3d(Vector3d::Zero());
    return {centre.array() - smallestFramedSize / 2, centre.array() + smallestFramedSize / 2};
}

Camera cameraOf(const Projector& projector, PhotoSize photo) {
    const Intrinsics seen = intrinsicsOf(projector, photo);
    Camera camera;
    camera.eye = projector.pose.translation();
    camera.target = camera.eye - projector.pose.linear().col(2);
    camera.up = projector.pose.linear().col(1);
    camera.verticalFieldOfView = 2 * std::atan(photo.height / (2 * seen.fy));
    camera.stretch = seen.fx / seen.fy;
    camera.centre = {seen.cx / photo.width, seen.cy / photo.height};
    return camera;
}

std::optional<StandardView> standardViewFromName(const std::string& name) {
    constexpr std::pair<const char*, StandardView> names[] = {
        {"front", StandardView::Front}, {"back", StandardView::Back}, {"left", StandardView::Left},
        {"right", StandardView::Right}, {"top", StandardView::Top},   {"bottom", StandardView::Bottom}};
    for (const auto& [known, view] : names)
        if (name == known) return view;
    return std::nullopt;
}

Camera framedCamera(const AlignedBox3d& box, StandardView view, double aspect) {
    const auto [direction, up] = directionAndUp(view);
    Camera camera;
    camera.eye = direction;
    camera.up = up;
    return reframed(camera, box, aspect);
}

/// Perspective: a corner at depth z before the centre and s aside is seen within the picture from a distance
/// of z + s / slope or more. The largest of the eight is the least distance from which all of the box is
/// seen. A sphere around the box would be simpler, and leave a long organ small in the picture. Without
/// perspective the largest s alone counts, and the eye stands as far off as with it.
Camera reframed(const Camera& camera, const AlignedBox3d& box, double aspect) {
    const AlignedBox3d shown = drawnBox(box);
    const Matrix3d axes = cameraAxes(camera);
    const double slope = std::tan(camera.verticalFieldOfView / 2) * framedShare;
    double distance = smallestDistance, widest = 0;
    for (int i = 0; i < 8; ++i) {
        const Vector3d offset = axes.transpose() * (corner(shown, i) - shown.center());
        const double sideways = std::max(std::abs(offset.x()) / aspect, std::abs(offset.y()));
        widest = std::max(widest, sideways);
        distance = std::max(distance, offset.z() + sideways / slope);
    }
    Camera result = camera;
    if (camera.orthographicHeight) result.orthographicHeight = heightWithin(2 * widest / framedShare, camera);
    result.target = shown.center();
    result.eye = result.target + distance * axes.col(2);
    result.up = axes.col(1);
    return result;
}

Camera orthographic(const Camera& camera) {
    Camera result = camera;
    result.orthographicHeight = pictureHeightAtTarget(camera);
    return result;
}

Camera perspective(const Camera& camera) {
    Camera result = camera;
    result.orthographicHeight.reset();
    const double distance = pictureHeightAtTarget(camera) / heightFrom(1, camera);
    result.eye = camera.target + distance * cameraAxes(camera).col(2);
    return result;
}

Camera standingBefore(const Camera& camera, const AlignedBox3d& box) {
    if (!camera.orthographicHeight || box.isEmpty()) return camera;
    const AlignedBox3d held = drawnBox(box);
    const Vector3d backwards = cameraAxes(camera).col(2);
    double farthest = 0;
    for (int i = 0; i < 8; ++i)
        farthest = std::max(farthest, (corner(held, i) - camera.target).dot(backwards));
    Camera result = camera;
    result.eye = camera.target + (farthest + held.diagonal().norm()) * backwards;
    return result;
}

Camera orbited(const Camera& camera, double right, double upwards) {
    const Matrix3d turned = turnedAxes(camera, right, upwards);
    Camera result = camera;
    result.eye = camera.target + (camera.eye - camera.target).norm() * turned.col(2);
    result.up = turned.col(1);
    return result;
}

/// The axes turn as when the eye goes round, the other way: who looks to the right looks from the left.
Camera lookingAround(const Camera& camera, double right, double upwards) {
    const Matrix3d turned = turnedAxes(camera, -right, -upwards);
    Camera result = camera;
    result.target = camera.eye - (camera.eye - camera.target).norm() * turned.col(2);
    result.up = turned.col(1);
    return result;
}

Camera panned(const Camera& camera, double right, double upwards) {
    const Matrix3d axes = cameraAxes(camera);
    const Vector3d shift = pictureHeightAtTarget(camera) * (right * axes.col(0) + upwards * axes.col(1));
    Camera result = camera;
    result.eye += shift;
    result.target += shift;
    return result;
}

Camera zoomed(const Camera& camera, double factor) {
    const Vector3d backwards = cameraAxes(camera).col(2);
    const double distance = factor * (camera.eye - camera.target).norm();
    Camera result = camera;
    if (camera.orthographicHeight) {
        result.orthographicHeight = heightWithin(factor * *camera.orthographicHeight, camera);
        return result;
    }
    result.eye = camera.target + std::clamp(distance, smallestDistance, largestDistance) * backwards;
    return result;
}

/// Zooming alone moves what lies under the pointer away from the middle. At the target's depth the picture
/// shrinks by the ratio of its heights; panning by that part of the way from the middle puts the point under
/// the pointer again.
Camera zoomedAbout(const Camera& camera, double factor, const Vector2d& point, double aspect) {
    const Camera closer = zoomed(camera, factor);
    const double shrunk = pictureHeightAtTarget(camera) / pictureHeightAtTarget(closer) - 1;
    return panned(closer, shrunk * (point.x() - 0.5) * aspect, shrunk * (0.5 - point.y()));
}

/// A map that scales about a point keeps all directions from it: the picture's point stays. Without
/// perspective the height is what comes closer; the line of sight goes with it all the same, so that
/// perspective, once it is back, shows it from as near.
Camera scaledAbout(const Camera& camera, double factor, const Vector3d& point) {
    Camera result = zoomed(camera, factor); // within the limits
    const double share = camera.orthographicHeight
                             ? *result.orthographicHeight / *camera.orthographicHeight
                             : (result.eye - result.target).norm() / (camera.eye - camera.target).norm();
    result.target = point + share * (camera.target - point);
    result.eye = camera.orthographicHeight ? Vector3d(camera.eye + result.target - camera.target)
                                           : Vector3d(point + share * (camera.eye - point));
    return result;
}

} // namespace esm

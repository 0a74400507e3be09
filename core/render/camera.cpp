#include "core/render/camera.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace esm {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double smallestDistance = 1e-5;   // m
constexpr double largestDistance = 1e3;     // m
constexpr double smallestFramedSize = 0.01; // m
constexpr double framedShare = 0.88;        // of the picture's width or height

/// An empty scene, a single point or a place that is not finite has no size to look at: a centimetre stands
/// in for it, so that every camera has a distance and every projection two planes.
AlignedBox3d usableBox(const AlignedBox3d& box) {
    const bool usable = !box.isEmpty() && box.min().allFinite() && box.max().allFinite();
    if (usable && box.diagonal().norm() > smallestDistance) return box;
    const Vector3d centre = usable ? Vector3d(box.center()) : Vector3d(Vector3d::Zero());
    return {centre.array() - smallestFramedSize / 2, centre.array() + smallestFramedSize / 2};
}

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

double pictureHeightAtTarget(const Camera& camera) {
    return 2 * std::tan(camera.verticalFieldOfView / 2) * (camera.eye - camera.target).norm();
}

Vector3d corner(const AlignedBox3d& box, int index) {
    return box.corner(static_cast<AlignedBox3d::CornerType>(index));
}

} // namespace

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
/// seen. A sphere around the box would be simpler, and leave a long organ small in the picture.
Camera reframed(const Camera& camera, const AlignedBox3d& box, double aspect) {
    const AlignedBox3d shown = usableBox(box);
    const Matrix3d axes = cameraAxes(camera);
    const double slope = std::tan(camera.verticalFieldOfView / 2) * framedShare;
    double distance = smallestDistance;
    for (int i = 0; i < 8; ++i) {
        const Vector3d offset = axes.transpose() * (corner(shown, i) - shown.center());
        const double sideways = std::max(std::abs(offset.x()) / aspect, std::abs(offset.y()));
        distance = std::max(distance, offset.z() + sideways / slope);
    }
    Camera result = camera;
    result.target = shown.center();
    result.eye = result.target + distance * axes.col(2);
    result.up = axes.col(1);
    return result;
}

/// First up or down about the camera's own sideways axis, then about the vertical of space, so that the
/// horizon stays level however long one turns. The limit is a quarter turn either way, straight from above
/// and below.
Camera orbited(const Camera& camera, double right, double upwards) {
    const Matrix3d axes = cameraAxes(camera);
    // The up direction never turns below the horizon: beyond it, "right" would turn the wrong way.
    const double elevation = std::atan2(axes.col(2).y(), axes.col(1).y());
    constexpr double limit = pi / 2;
    const double rise = std::clamp(elevation + upwards, -limit, limit) - elevation;
    const Eigen::AngleAxisd aboutVertical(right, Vector3d::UnitY());
    const Eigen::AngleAxisd aboutSideways(-rise, axes.col(0));
    const Matrix3d turned = aboutVertical.toRotationMatrix() * aboutSideways.toRotationMatrix() * axes;
    Camera result = camera;
    result.eye = camera.target + (camera.eye - camera.target).norm() * turned.col(2);
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

/// Gram and Schmidt's: backwards is kept, the up direction only says which way right goes. Where up lies
/// along the line of sight another one is taken, so that the axes are never NaN.
Matrix3d cameraAxes(const Camera& camera) {
    Vector3d backwards = camera.eye - camera.target;
    backwards = backwards.norm() > 0 ? backwards.normalized() : Vector3d::UnitZ();
    Vector3d right = camera.up.cross(backwards);
    if (right.norm() <= 1e-9 * camera.up.norm()) { // up along the line of sight, or no direction at all
        const Vector3d replacement = std::abs(backwards.y()) > 0.5 ? Vector3d(0, 0, -1) : Vector3d(0, 1, 0);
        right = replacement.cross(backwards);
    }
    right.normalize();
    Matrix3d axes;
    axes << right, backwards.cross(right), backwards;
    return axes;
}

Matrix4d viewMatrix(const Camera& camera) {
    const Matrix3d rotation = cameraAxes(camera).transpose();
    Matrix4d view = Matrix4d::Identity();
    view.topLeftCorner<3, 3>() = rotation;
    view.topRightCorner<3, 1>() = -rotation * camera.eye;
    return view;
}

/// The matrix of glFrustum, but with the principal point moved off the middle (centre) and pixels that need
/// not be square (stretch), as a calibrated camera has them. Near and far plane are put close around what is
/// shown, for every picture anew: depth values lie as 1 / z, so that a near plane put too close costs all
/// precision farther back.
Matrix4d projectionMatrix(const Camera& camera, double aspect, const AlignedBox3d& box) {
    const AlignedBox3d held = usableBox(box);
    const Vector3d backwards = cameraAxes(camera).col(2);
    double nearest = HUGE_VAL, farthest = smallestDistance;
    for (int i = 0; i < 8; ++i) {
        const double depth = (camera.eye - corner(held, i)).dot(backwards);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    // A near plane much closer than the far one would leave no depth precision at the organ.
    const double zFar = farthest * 1.01;
    const double zNear = std::max(nearest * 0.99, zFar * 1e-3);
    const double scale = 1 / std::tan(camera.verticalFieldOfView / 2);
    Matrix4d projection = Matrix4d::Zero();
    projection(0, 0) = scale * camera.stretch / aspect;
    projection(1, 1) = scale;
    projection(0, 2) = 1 - 2 * camera.centre.x();
    projection(1, 2) = 2 * camera.centre.y() - 1;
    projection(2, 2) = -(zFar + zNear) / (zFar - zNear);
    projection(2, 3) = -2 * zFar * zNear / (zFar - zNear);
    projection(3, 2) = -1;
    return projection;
}

Ray pickRay(const Camera& camera, double x, double y, double aspect) {
    const double slope = std::tan(camera.verticalFieldOfView / 2);
    const Vector3d inCamera(2 * (x - camera.centre.x()) * slope * aspect / camera.stretch,
                            2 * (camera.centre.y() - y) * slope, -1);
    return {camera.eye, (cameraAxes(camera) * inCamera).normalized()};
}

std::optional<Vector2d> picturePoint(const Camera& camera, const Vector3d& point, double aspect) {
    const Vector3d inCamera = cameraAxes(camera).transpose() * (point - camera.eye);
    if (!(inCamera.z() < 0)) return std::nullopt;
    const double slope = std::tan(camera.verticalFieldOfView / 2) * -inCamera.z();
    return Vector2d(camera.centre.x() + 0.5 * inCamera.x() * camera.stretch / (slope * aspect),
                    camera.centre.y() - 0.5 * inCamera.y() / slope);
}

} // namespace esm

#include "core/render/camera.h"

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

constexpr double nearestShown = 1e-5; // m

/// m per m of distance; of a perspective camera.
double heightPerDepth(const Camera& camera) {
    return 2 * std::tan(camera.verticalFieldOfView / 2);
}

/// How deep before the eye a box begins and ends, m; below 0 behind it.
std::pair<double, double> depthsOf(const Camera& camera, const AlignedBox3d& box) {
    const Vector3d backwards = cameraAxes(camera).col(2);
    std::pair<double, double> depths{HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < 8; ++i) {
        const Vector3d corner = box.corner(static_cast<AlignedBox3d::CornerType>(i));
        const double depth = (camera.eye - corner).dot(backwards);
        depths = {std::min(depths.first, depth), std::max(depths.second, depth)};
    }
    return depths;
}

/// The matrix of glFrustum, but with the principal point moved off the middle (centre) and pixels that need
/// not be square (stretch), as a calibrated camera has them. Near and far plane are put close around what is
/// shown, for every picture anew: depth values lie as 1 / z, so that a near plane put too close costs all
/// precision farther back.
Matrix4d perspectiveMatrix(const Camera& camera, double aspect, const AlignedBox3d& box) {
    const std::pair<double, double> depths = depthsOf(camera, box);
    // Who is close to the surface, or among it, sees it whole; a near plane much closer than that would leave
    // no depth precision at the organ.
    constexpr double nearestShare = 3e-4;
    const double zFar = std::max(depths.second, nearestShown) * 1.01;
    const double zNear = std::max(depths.first * 0.99, zFar * nearestShare);
    const double scale = 2 / heightPerDepth(camera);
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

/// The matrix of glOrtho. Depth is as fine everywhere, so the planes may stand well off the box; what lies
/// behind the eye is drawn as well.
Matrix4d orthographicMatrix(const Camera& camera, double aspect, const AlignedBox3d& box) {
    const std::pair<double, double> depths = depthsOf(camera, box);
    const double margin = 0.01 * box.diagonal().norm();
    const double zNear = depths.first - margin, zFar = depths.second + margin;
    const double scale = 2 / *camera.orthographicHeight;
    Matrix4d projection = Matrix4d::Identity();
    projection(0, 0) = scale * camera.stretch / aspect;
    projection(1, 1) = scale;
    projection(0, 3) = 2 * camera.centre.x() - 1;
    projection(1, 3) = 1 - 2 * camera.centre.y();
    projection(2, 2) = -2 / (zFar - zNear);
    projection(2, 3) = -(zFar + zNear) / (zFar - zNear);
    return projection;
}

} // namespace

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

double pictureHeightAt(const Camera& camera, const Vector3d& point) {
    if (camera.orthographicHeight) return *camera.orthographicHeight;
    return heightPerDepth(camera) * (camera.eye - point).dot(cameraAxes(camera).col(2));
}

Vector3d towardsViewer(const Camera& camera, const Vector3d& point) {
    return camera.orthographicHeight ? Vector3d(cameraAxes(camera).col(2))
                                     : (camera.eye - point).normalized();
}

Vector3d viewpoint(const Camera& camera, double sceneSize) {
    constexpr double farOff = 1e6;
    return camera.orthographicHeight
               ? Vector3d(camera.target + farOff * sceneSize * cameraAxes(camera).col(2))
               : camera.eye;
}

Matrix4d viewMatrix(const Camera& camera) {
    const Matrix3d rotation = cameraAxes(camera).transpose();
    Matrix4d view = Matrix4d::Identity();
    view.topLeftCorner<3, 3>() = rotation;
    view.topRightCorner<3, 1>() = -rotation * camera.eye;
    return view;
}

Matrix4d projectionMatrix(const Camera& camera, double aspect, const AlignedBox3d& box) {
    return camera.orthographicHeight ? orthographicMatrix(camera, aspect, drawnBox(box))
                                     : perspectiveMatrix(camera, aspect, drawnBox(box));
}

Ray pickRay(const Camera& camera, double x, double y, double aspect) {
    const Matrix3d axes = cameraAxes(camera);
    const double height = camera.orthographicHeight.value_or(heightPerDepth(camera));
    const Vector3d aside = axes * Vector3d((x - camera.centre.x()) * height * aspect / camera.stretch,
                                           (camera.centre.y() - y) * height, 0);
    if (camera.orthographicHeight) return {camera.eye + aside, -axes.col(2)};
    return {camera.eye, (aside - axes.col(2)).normalized()};
}

std::optional<Vector2d> picturePoint(const Camera& camera, const Vector3d& point, double aspect) {
    const double height = pictureHeightAt(camera, point);
    if (!(height > 0)) return std::nullopt;
    const Vector3d inCamera = cameraAxes(camera).transpose() * (point - camera.eye);
    return Vector2d(camera.centre.x() + inCamera.x() * camera.stretch / (height * aspect),
                    camera.centre.y() - inCamera.y() / height);
}

} // namespace esm

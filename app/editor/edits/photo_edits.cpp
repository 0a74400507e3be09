#include "app/editor/edits/photo_edits.h"

#include "core/support/angles.h"
#include "core/surface/surface_query.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Nearest point of the organ's box along the view direction, as a distance from the eye.
double nearestDepth(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& eye,
                    const Eigen::Vector3d& direction) {
    double nearest = std::numeric_limits<double>::max();
    for (int corner = 0; corner < 8; ++corner) {
        const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
        nearest = std::min(nearest, (box.corner(type) - eye).dot(direction));
    }
    return nearest;
}

PhotoSize shownSize(const Image& photo) {
    return photo.empty() ? PhotoSize{1, 1} : sizeOf(photo);
}

/// How far before the projector its middle meets the organ, or else the organ's middle lies.
double depthOfOrgan(const Projector& projector, const TriangleMesh& mesh) {
    const Eigen::Vector3d origin = projector.pose.translation(), towards = -projector.pose.linear().col(2);
    const auto hit = SurfaceQuery(mesh.vertices, mesh.triangles).firstHit({origin, towards});
    if (hit && hit->distance > 0) return hit->distance;
    const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
    const double middle = (box.center() - origin).dot(towards);
    return middle > 0 ? middle : 0.5 * box.diagonal().norm();
}

/// Lengths that files can hold.
double photoLength(double metres) {
    return std::clamp(metres, texture_limits::shortestPhoto, texture_limits::longestPhoto);
}

} // namespace

Projector aimedByCamera(const Projector& before, const Camera& camera, const Image& photo,
                        const TriangleMesh& mesh) {
    Projector projector = before;
    if (before.kind == ProjectorKind::Parallel) {
        projector.pose = projectorFromCamera(camera, photo, mesh).pose;
        return projector;
    }
    const Camera seeing = perspective(camera);
    projector.pose.linear() = cameraAxes(seeing);
    projector.pose.translation() = seeing.eye;
    projector.intrinsics.reset();
    projector.areIntrinsicsFound = false;
    projector.fieldOfView = toDegrees(seeing.verticalFieldOfView);
    return projector;
}

Projector ofKind(ProjectorKind kind, const Projector& before, const Image& photo, const TriangleMesh& mesh) {
    if (kind == before.kind) return before;
    const double depth = depthOfOrgan(before, mesh);
    Projector projector = before;
    projector.kind = kind;
    if (kind == ProjectorKind::Perspective) {
        projector.fieldOfView = Projector().fieldOfView;
        projector.intrinsics.reset();
        projector.areIntrinsicsFound = false;
        const double distance = before.height / (2 * std::tan(toRadians(projector.fieldOfView) / 2));
        projector.pose.translation() += (distance - depth) * before.pose.linear().col(2);
        return projector;
    }
    const auto corners = photoCorners(before, shownSize(photo), depth);
    projector.width = photoLength((corners[1] - corners[0]).norm());
    projector.height = photoLength((corners[3] - corners[0]).norm());
    const Eigen::Vector3d towards = -before.pose.linear().col(2);
    const Eigen::AlignedBox3d box = boundingBox(mesh.vertices);
    const double inFront = nearestDepth(box, before.pose.translation(), towards);
    const double setBack = std::max(0.0, std::min(inFront - 0.04 * box.diagonal().norm(), depth));
    projector.pose.translation() = (corners[0] + corners[2]) / 2 + (setBack - depth) * towards;
    projector.intrinsics.reset();
    projector.areIntrinsicsFound = false;
    return projector;
}

/// A lens is measured in heights of the photo; the picture is `heights` of them high, so that its other parts
/// are seen beside the photo, which lies in the picture's middle wherever its line of sight ends.
Camera cameraThrough(const Projector& projector, PhotoSize photo, const TriangleMesh& mesh, double aspect) {
    constexpr double photoShare = 0.8; // of the picture's width or height
    const bool isParallel = projector.kind == ProjectorKind::Parallel;
    const double photoAspect = isParallel ? projector.width / projector.height : photo.aspect();
    const double heights = std::max(1.0, photoAspect / aspect) / photoShare;
    Camera camera;
    if (isParallel) {
        camera.orthographicHeight = heights * projector.height;
    } else {
        camera = cameraOf(projector, photo);
        const Eigen::Vector2d beside(photoAspect * (camera.centre.x() - 0.5), camera.centre.y() - 0.5);
        camera.centre = {0.5 + beside.x() / (heights * aspect), 0.5 + beside.y() / heights};
        camera.verticalFieldOfView = 2 * std::atan(heights * std::tan(camera.verticalFieldOfView / 2));
    }
    const Eigen::Matrix3d axes = projector.pose.linear();
    camera.eye = projector.pose.translation();
    camera.target = camera.eye - depthOfOrgan(projector, mesh) * axes.col(2);
    camera.up = axes.col(1);
    return camera;
}

Projector projectorFromCamera(const Camera& camera, const Image& photo, const TriangleMesh& mesh) {
    const auto box = boundingBox(mesh.vertices);
    const Eigen::Vector3d towards = (camera.target - camera.eye).normalized();
    const Eigen::Vector3d right = towards.cross(camera.up).normalized();
    Eigen::Matrix3d axes;
    axes << right, right.cross(towards), -towards;

    const double extent = 0.4 * box.diagonal().norm();
    const double depth = nearestDepth(box, camera.eye, towards) - 0.1 * extent;
    const double proportion = photo.empty() ? 1 : double(photo.width) / photo.height;
    Projector projector;
    projector.pose.linear() = axes;
    projector.pose.translation() = camera.eye + depth * towards;
    projector.width = proportion >= 1 ? extent : extent * proportion;
    projector.height = projector.width / proportion;
    return projector;
}

} // namespace esm

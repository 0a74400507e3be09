#include "core/texture/projection/projector.h"

#include "core/support/angles.h"
#include "core/support/smooth_step.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double fullWeightUpTo = toRadians(60), noWeightFrom = toRadians(85);
constexpr double fullWeightCosine = 0.5; // of the former

/// From the projector's own space to the photo, rows as in `photoMatrix`.
Eigen::Matrix4d fromOwnSpace(const Projector& projector, PhotoSize photo) {
    Eigen::Matrix4d matrix;
    if (projector.kind == ProjectorKind::Perspective) {
        const Intrinsics camera = intrinsicsOf(projector, photo);
        matrix << camera.fx, 0, -camera.cx, 0, //
            0, -camera.fy, -camera.cy, 0,      //
            0, 0, -1, 0,                       //
            0, 0, -1, 0;
    } else {
        matrix << photo.width / projector.width, 0, 0, 0.5 * photo.width, //
            0, -photo.height / projector.height, 0, 0.5 * photo.height,   //
            0, 0, 0, 1,                                                   //
            0, 0, -1, 0;
    }
    return matrix;
}

} // namespace

Intrinsics intrinsicsOf(const Projector& projector, PhotoSize photo) {
    if (projector.intrinsics) return *projector.intrinsics;
    const double focal = photo.height / (2 * std::tan(toRadians(projector.fieldOfView) / 2));
    return {focal, focal, 0.5 * photo.width, 0.5 * photo.height};
}

std::array<Eigen::Vector3d, 4> photoCorners(const Projector& projector, PhotoSize photo, double depth) {
    double left = -projector.width / 2, top = projector.height / 2, right = -left, bottom = -top;
    if (projector.kind == ProjectorKind::Perspective) {
        const auto [fx, fy, cx, cy] = intrinsicsOf(projector, photo);
        left = -cx / fx * depth;
        right = (photo.width - cx) / fx * depth;
        top = cy / fy * depth;
        bottom = (cy - photo.height) / fy * depth;
    }
    return {projector.pose * Eigen::Vector3d(left, bottom, -depth),
            projector.pose * Eigen::Vector3d(right, bottom, -depth),
            projector.pose * Eigen::Vector3d(right, top, -depth),
            projector.pose * Eigen::Vector3d(left, top, -depth)};
}

Eigen::Matrix4d photoMatrix(const Projector& projector, PhotoSize photo) {
    return fromOwnSpace(projector, photo) * projector.pose.inverse().matrix();
}

std::optional<Eigen::Vector3d> project(const Projector& projector, PhotoSize photo,
                                       const Eigen::Vector3d& point) {
    const Eigen::Vector4d seen = photoMatrix(projector, photo) * point.homogeneous();
    if (!(seen.z() > 0)) return std::nullopt;
    return Eigen::Vector3d(seen.x() / seen.z(), seen.y() / seen.z(), seen.w());
}

double angleWeight(double cosine) {
    if (!std::isfinite(cosine)) return 0;
    if (std::abs(cosine) >= fullWeightCosine) return 1; // most surface, without an arc cosine
    const double angle = std::acos(std::min(std::abs(cosine), 1.0));
    return 1 - smoothStep(fullWeightUpTo, noWeightFrom, angle);
}

} // namespace esm

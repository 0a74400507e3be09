#include "core/texture/projection/pinhole_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

std::vector<double> pairErrors(const PinholeCamera& camera, const std::vector<LandmarkPair>& pairs) {
    const auto& [fx, fy, cx, cy] = camera.intrinsics;
    std::vector<double> errors;
    errors.reserve(pairs.size());
    for (const LandmarkPair& pair : pairs) {
        const Eigen::Vector3d seen = camera.rotation * pair.organ + camera.translation;
        const Eigen::Vector2d place(fx * seen.x() / seen.z() + cx, fy * seen.y() / seen.z() + cy);
        const double error = (place - pair.photo).norm();
        errors.push_back(seen.z() > 0 && std::isfinite(error) ? error
                                                              : std::numeric_limits<double>::infinity());
    }
    return errors;
}

/// Capped, so that one pair that was mixed up costs no more than any other that does not fit, and cannot
/// outweigh all that do (M-estimators; MSAC of Torr and Zisserman 2000).
double cappedSquares(const std::vector<double>& errors, double tolerance) {
    double sum = 0;
    for (const double error : errors)
        sum += std::pow(std::min(error, tolerance), 2);
    return sum;
}

PinholeCamera moved(PinholeCamera camera, const CameraStep& step) {
    const Eigen::Vector3d turn = step.segment<3>(camera_step::turn);
    if (turn.norm() > 0)
        camera.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * camera.rotation;
    camera.translation += step.segment<3>(camera_step::shift);
    const double longer = std::exp(step[camera_step::focalLength]);
    camera.intrinsics.fx *= longer * std::exp(step[camera_step::pixelAspect]);
    camera.intrinsics.fy *= longer;
    camera.intrinsics.cx += step[camera_step::principalPoint];
    camera.intrinsics.cy += step[camera_step::principalPoint + 1];
    return camera;
}

} // namespace esm

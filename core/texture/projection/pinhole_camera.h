#pragma once

#include "core/texture/intrinsics.h"
#include "core/texture/projection/landmark_pair.h"

#include <Eigen/Geometry>

#include <vector>

namespace esm {

/// A pinhole camera in space with OpenCV's axes: x right, y down, z forwards.
struct PinholeCamera {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); ///< model → camera
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    Intrinsics intrinsics{1, 1, 0, 0};

    Eigen::Vector3d eye() const { return -(rotation.transpose() * translation); }
};

/// Photo pixels from each landmark to where the camera sees it; infinite for one that is not before it.
std::vector<double> pairErrors(const PinholeCamera& camera, const std::vector<LandmarkPair>& pairs);

/// What a camera is worth: the squares of the errors, each at most the tolerance's.
double cappedSquares(const std::vector<double>& errors, double tolerance);

/// The numbers by which a camera changes: a small turn in front of its rotation and a shift of its
/// translation, the logarithm of the focal length, the principal point (pixels), and the logarithm of the
/// pixel aspect, fx / fy. By logarithms no step can make a length negative.
namespace camera_step {
constexpr Eigen::Index turn = 0, shift = 3, focalLength = 6, principalPoint = 7, pixelAspect = 9, count = 10;
}
using CameraStep = Eigen::Matrix<double, camera_step::count, 1>;

PinholeCamera moved(PinholeCamera camera, const CameraStep& step);

} // namespace esm

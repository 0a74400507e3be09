#pragma once

#include "core/texture/projection/pose_fit.h"

namespace esm {

/// A pinhole camera in space with OpenCV's axes: x right, y down, z forwards.
struct PinholeCamera {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); ///< model → camera
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    Intrinsics intrinsics{1, 1, 0, 0};
};

/// Photo pixels from each landmark to where the camera sees it; infinite for one that is not before it.
std::vector<double> pairErrors(const PinholeCamera& camera, const std::vector<LandmarkPair>& pairs);

/// The cameras of these intrinsics that see three of the pairs exactly, over many triples in a fixed order,
/// and most of the others within `tolerance` (pixels); the best first, at most `count`.
std::vector<PinholeCamera> likelyCameras(const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                                         double tolerance, std::size_t count);

/// What a candidate is worth: the squares of the errors, each at most the tolerance's.
double cappedSquares(const std::vector<double>& errors, double tolerance);

enum class Freedom { Pose, PoseAndFocalLength };

/// The camera with the least squares of errors near `start`; only pairs that count.
/// @param slack set to the standard deviation of the focal length's logarithm for errors of one pixel, where
/// it is free
PinholeCamera leastSquares(PinholeCamera start, const std::vector<LandmarkPair>& pairs,
                           const std::vector<bool>& counts, Freedom freedom, double* slack = nullptr);

} // namespace esm

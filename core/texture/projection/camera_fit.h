#pragma once

#include "core/texture/projection/usual_camera.h"

namespace esm {

/// What of a camera is sought beside where it stands.
struct CameraFreedom {
    bool focalLength = false, principalPoint = false, pixelAspect = false;

    bool operator==(const CameraFreedom&) const = default;
};
constexpr CameraFreedom poseOnly{}, poseAndFocalLength{true, false, false}, wholeCamera{true, true, true};

/// Numbers that a freedom leaves open, 6 to 10.
int unknownsOf(const CameraFreedom& freedom);

/// How far clicks miss their landmarks: photo pixels, one standard deviation in each direction.
double usualClickNoise(PhotoSize photo);

struct CameraFit {
    PinholeCamera camera;
    double clickNoise = 0;     ///< as told by the errors that are left, see `usualClickNoise`
    double told = 0;           ///< how many of the unknowns the pairs tell, and not what is usual
    Eigen::MatrixXd precision; ///< 10 × 10, by a `CameraStep`: what pairs and usual camera say together
};

struct CameraProblem {
    const std::vector<LandmarkPair>& pairs;
    const std::vector<bool>& counts; ///< which of the pairs take part
    const UsualCamera& usual;
    double usualNoise; ///< see `usualClickNoise`
};

/// The likeliest camera near `start`: least squares of the pairs' errors and of what is unusual in it, each
/// by how sure it is (Levenberg-Marquardt). What is not free stays as in `start`.
/// @param rounds in which the clicks' noise is taken from the errors anew; with one it is the usual one
CameraFit fitCamera(PinholeCamera start, const CameraProblem& problem, const CameraFreedom& freedom,
                    int rounds = 1);

} // namespace esm

#pragma once

#include "core/support/words.h"
#include "core/texture/projection/usual_camera.h"

#include <array>
#include <vector>

namespace esm {

/// What of a camera is sought beside where it stands.
struct CameraFreedom {
    bool focalLength = false, principalPoint = false, pixelAspect = false;

    bool operator==(const CameraFreedom&) const = default;
};
constexpr CameraFreedom poseOnly{}, poseAndFocalLength{true, false, false}, wholeCamera{true, true, true};

/// Parts of a camera that may be sought beside where it stands.
enum class CameraPart { FocalLength, PrincipalPoint, PixelAspect };
template<>
inline constexpr auto wordsOf<CameraPart> = std::array{Word{CameraPart::FocalLength, "focal_length"},
                                                       Word{CameraPart::PrincipalPoint, "principal_point"},
                                                       Word{CameraPart::PixelAspect, "pixel_aspect"}};

/// Which numbers of a `CameraStep` a part consists of, and which a freedom leaves open, in their order.
std::vector<Eigen::Index> numbersOf(CameraPart part);
std::vector<Eigen::Index> freeNumbers(const CameraFreedom& freedom);

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

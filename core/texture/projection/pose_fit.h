#pragma once

#include "core/texture/projection/camera_sources.h"
#include "core/texture/projection/landmark_pair.h"
#include "core/texture/projection/landmark_spread.h"
#include "core/texture/projection/projector.h"

#include <optional>
#include <vector>

namespace esm {

struct PoseFit {
    Projector projector;        ///< in perspective
    std::vector<double> errors; ///< photo pixels from each landmark to where it is seen; infinite for one
                                ///< behind the eye
    std::vector<bool> outliers; ///< pairs that do not fit the others and did not count
    double error;               ///< photo pixels, root of the mean square over the others
    PartSource focalLength, principalPoint, pixelAspect;
    double clickNoise; ///< photo pixels, a standard deviation in each direction, told by the errors
    double eyeWithin;  ///< m: so near to the true eye with a probability of 95 %
    double turnWithin; ///< degrees: so near to the true turn with the same
    std::optional<CameraPart> dominating; ///< an assumption that makes the pose twice as unsure and more
    std::vector<Weakness> weaknesses;
};

/// What the program knows of a photo's camera before it looks at the pairs.
struct PhotoCamera {
    PhotoSize size;
    std::optional<Intrinsics> intrinsics;

    bool operator==(const PhotoCamera&) const = default;
};

/// The pose from which a camera sees the landmarks where the photo shows them: from three of them each
/// (P3P by OpenCV, up to 1000 triples in a fixed order), chosen by how many of the others agree within 1 % of
/// the photo's diagonal, then all that agree by least squares (Levenberg-Marquardt). Without intrinsics the
/// focal length, the principal point and the pixel aspect are found as well, as far as six pairs or more tell
/// them. Deterministic.
/// @throws InvalidModel with one message: fewer than four pairs, not finite, outside the photo, two at one
/// point, on a line, or pairs that no camera sees together, as mirrored ones
PoseFit fitPose(const std::vector<LandmarkPair>& pairs, const PhotoCamera& camera);

} // namespace esm

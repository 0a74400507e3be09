#pragma once

#include "core/texture/projection/landmark_pair.h"
#include "core/texture/projection/projector.h"

#include <string>
#include <vector>

namespace esm {

enum class FocalLength {
    Given,    ///< with the intrinsics
    Measured, ///< found with the pose
    Assumed,  ///< `assumedFieldOfView`: the pairs do not tell it
};

struct PoseFit {
    Projector projector;        ///< in perspective
    std::vector<double> errors; ///< photo pixels from each landmark to where it is seen; infinite for one
                                ///< behind the eye
    std::vector<bool> outliers; ///< pairs that do not fit the others and did not count
    double error;               ///< photo pixels, root of the mean square over the others
    FocalLength focalLength;
};

constexpr double assumedFieldOfView = 60; ///< degrees, vertical

/// What the program knows of a photo's camera before it looks at the pairs.
struct PhotoCamera {
    PhotoSize size;
    std::optional<Intrinsics> intrinsics;

    bool operator==(const PhotoCamera&) const = default;
};

/// The pose from which a camera sees the landmarks where the photo shows them: from three of them each
/// (P3P by OpenCV, up to 1000 triples in a fixed order), chosen by how many of the others agree within 1 % of
/// the photo's diagonal, then all that agree by least squares (Levenberg-Marquardt). Without intrinsics the
/// focal length is found as well where six pairs or more tell it. Deterministic.
/// @throws InvalidModel with one message: fewer than four pairs, not finite, outside the photo, two at one
/// point, on a line, or pairs that no camera sees together, as mirrored ones
PoseFit fitPose(const std::vector<LandmarkPair>& pairs, const PhotoCamera& camera);

} // namespace esm

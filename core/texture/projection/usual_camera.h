#pragma once

#include "core/texture/projection/pinhole_camera.h"

namespace esm {

constexpr double assumedFieldOfView = 60; ///< degrees, vertical

/// What is likely of a photo's camera before any landmark is seen: a field of view about
/// `assumedFieldOfView`, the principal point about the photo's middle, pixels about square. Each follows
/// Student's distribution with three degrees of freedom, which is as sure as a normal one near its middle and
/// yet leaves room for a photo that was cropped or stretched.
struct UsualCamera {
    Intrinsics camera;     ///< the likeliest
    double focalScale;     ///< of the focal length's logarithm
    double principalScale; ///< pixels
    double aspectScale;    ///< of the pixel aspect's logarithm
};

UsualCamera usualCamera(PhotoSize photo);

/// −2 log of the density at a camera, up to a constant, with half its gradient and half its curvature by a
/// `CameraStep` (that of Gauss and Newton, never negative).
struct Unlikeliness {
    double value = 0;
    CameraStep gradient = CameraStep::Zero();
    CameraStep curvature = CameraStep::Zero();
};
Unlikeliness unlikeliness(const UsualCamera& usual, const Intrinsics& camera);

} // namespace esm

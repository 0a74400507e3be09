#pragma once

#include "core/texture/projection/camera_fit.h"

#include <optional>

namespace esm {

/// Where a part of the camera comes from.
enum class PartSource {
    Given,   ///< with the intrinsics
    Found,   ///< by the pairs, with the pose
    Assumed, ///< as usual cameras have it: the pairs do not tell it
};

template<>
inline constexpr auto wordsOf<PartSource> =
    std::array{Word{PartSource::Given, "given"}, Word{PartSource::Found, "measured"},
               Word{PartSource::Assumed, "assumed"}};

struct CameraSources {
    PartSource focalLength, principalPoint, pixelAspect;

    explicit CameraSources(PartSource all) : focalLength(all), principalPoint(all), pixelAspect(all) {}
};

/// What the pairs tell of a camera of which nothing was given.
/// @param whole the likeliest camera, all of it being free
CameraSources sourcesOf(const CameraFit& whole, const UsualCamera& usual);

/// The parts that are found, and found to be other than usual, with more certainty than 99 %; the focal
/// length always.
CameraFreedom oddParts(const CameraFit& whole, const UsualCamera& usual, const CameraSources& sources);

/// The camera with all parts that are not free as usual; its focal length as it is.
PinholeCamera withUsualParts(PinholeCamera camera, const UsualCamera& usual, const CameraFreedom& free);

/// Of the parts that are assumed the one that makes eye or turn the more unsure: were it known, the variance
/// would be less than half. Nothing where none does.
std::optional<CameraPart> dominatingAssumption(const CameraFit& whole, const CameraSources& sources);

} // namespace esm

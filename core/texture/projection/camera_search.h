#pragma once

#include "core/texture/projection/camera_fit.h"

namespace esm {

/// A camera, and the pairs that agree with it.
struct CameraCandidate {
    PinholeCamera camera;
    std::vector<bool> counts; ///< empty where none was found
    double squares = 0;       ///< pixels², see `cappedSquares`
};

std::size_t countOf(const std::vector<bool>& counts);

/// Two in three of the pairs at least, and four: any three fit some camera exactly, so that a few that agree
/// prove nothing.
bool isConvincing(const CameraCandidate& candidate);

/// The camera of these intrinsics with which the pairs agree best, and which of them do.
CameraCandidate foundPose(const std::vector<LandmarkPair>& pairs, const Intrinsics& camera, PhotoSize photo);

/// The same with an unknown camera.
CameraCandidate foundCamera(const std::vector<LandmarkPair>& pairs, PhotoSize photo);

} // namespace esm

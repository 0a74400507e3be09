#pragma once

#include "core/texture/projection/pinhole_camera.h"

namespace esm {

/// How long one searches: so many triples of pairs, and so many cameras that may be the best.
struct SearchEffort {
    std::size_t triples, cameras;
};

/// The cameras of these intrinsics that see three of the pairs exactly, over triples in a fixed order, and
/// most of the others within `tolerance` (pixels); the best first.
std::vector<PinholeCamera> likelyCameras(const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                                         double tolerance, const SearchEffort& effort);

} // namespace esm

#pragma once

#include "core/texture/intrinsics.h"
#include "core/texture/projection/landmark_pair.h"

#include <vector>

namespace esm {

constexpr std::size_t leastPairs = 4;

/// @throws InvalidModel with one message: fewer than `leastPairs`, not finite, outside the photo, two at one
/// point, or on a line
void requireUsable(const std::vector<LandmarkPair>& pairs, const PhotoSize& photo);

/// The pairs with the organ's points around the origin and of size 1, as solvers like them.
struct ScaledPairs {
    explicit ScaledPairs(const std::vector<LandmarkPair>& given);

    std::vector<LandmarkPair> pairs;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< m
    double size = 0;                                  ///< m
};

} // namespace esm

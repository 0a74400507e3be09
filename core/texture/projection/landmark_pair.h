#pragma once

#include <Eigen/Core>

namespace esm {

/// The same landmark in a photo and on an organ.
struct LandmarkPair {
    Eigen::Vector2d photo; ///< pixels from the top left corner
    Eigen::Vector3d organ; ///< m

    bool operator==(const LandmarkPair&) const = default;
};

} // namespace esm

#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace esm {

/// From a place of the plane to the nearest of a straight line's part; to its end where it has no length.
inline double distanceToSegment(const Eigen::Vector2d& place, const Eigen::Vector2d& from,
                                const Eigen::Vector2d& to) {
    const Eigen::Vector2d along = to - from;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0.0;
    return (place - from - share * along).norm();
}

} // namespace esm

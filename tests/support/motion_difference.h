#pragma once

#include <Eigen/Core>

#include <cmath>
#include <vector>

/// How far points are from a reference, relative to how far that moved from rest, in the mean square.
inline double motionDifference(const std::vector<Eigen::Vector3d>& points,
                               const std::vector<Eigen::Vector3d>& reference,
                               const std::vector<Eigen::Vector3d>& rest) {
    double apart = 0, way = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        apart += (points[i] - reference[i]).squaredNorm();
        way += (reference[i] - rest[i]).squaredNorm();
    }
    return std::sqrt(apart / way);
}

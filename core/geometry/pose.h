#pragma once

#include <Eigen/Geometry>

namespace esm {

/// A turn and a shift, from a thing's own space to the model's, m. Two are equal where all their numbers are:
/// Eigen's own transforms cannot be compared.
struct Pose : Eigen::Isometry3d {
    using Eigen::Isometry3d::Isometry3d;
    Pose(const Eigen::Isometry3d& transform) : Eigen::Isometry3d(transform) {}

    static Pose Identity() { return Eigen::Isometry3d::Identity(); }
    bool operator==(const Pose& other) const { return matrix() == other.matrix(); }
};

} // namespace esm

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace esm {

/// A parallel projector: the photo lies in its plane z = 0, centred on the origin, x right, y up, and is
/// thrown along −z [R 4.3.2.3].
struct Projector {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity(); ///< projector → model, m
    double width = 0.1, height = 0.1;                       ///< of the photo in space, m, > 0
    bool occlusion = true; ///< colour only what the projector sees: facing it and not hidden
};

/// Photo coordinates of a point: (0, 0) the top left corner, (1, 1) the bottom right, and the depth in front
/// of the photo's plane (m).
Eigen::Vector3d project(const Projector& projector, const Eigen::Vector3d& point);

} // namespace esm

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace esm {

/// A rotation as angles in degrees about its own x, then y, then z axis; x and z within ±180, y within ±90.
Eigen::Vector3d degreesOf(const Eigen::Matrix3d& rotation);
Eigen::Matrix3d rotationOf(const Eigen::Vector3d& degrees);

} // namespace esm

#include "app/editor/edits/angles.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

Eigen::Vector3d degreesOf(const Eigen::Matrix3d& r) {
    const double y = std::asin(std::clamp(r(0, 2), -1.0, 1.0));
    // At ±90 degrees about y only the sum of the other two is determined.
    const bool locked = std::abs(r(0, 2)) > 1 - 1e-12;
    const double x = locked ? std::atan2(r(2, 1), r(1, 1)) : std::atan2(-r(1, 2), r(2, 2));
    const double z = locked ? 0 : std::atan2(-r(0, 1), r(0, 0));
    return {toDegrees(x), toDegrees(y), toDegrees(z)};
}

Eigen::Matrix3d rotationOf(const Eigen::Vector3d& degrees) {
    return (Eigen::AngleAxisd(toRadians(degrees.x()), Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(toRadians(degrees.y()), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(toRadians(degrees.z()), Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

} // namespace esm

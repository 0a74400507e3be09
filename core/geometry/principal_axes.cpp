#include "core/geometry/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace esm {

using Eigen::Vector3d;

Vector3d meanOf(const std::vector<Vector3d>& points) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

Eigen::Matrix3d principalAxes(const std::vector<Vector3d>& points) {
    const Vector3d middle = meanOf(points);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& point : points)
        spread += (point - middle) * (point - middle).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
}

} // namespace esm

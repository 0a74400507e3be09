#include "core/geometry/ellipsoid.h"

#include <cmath>

namespace esm {

bool contains(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = ellipsoid.orientation.conjugate() * (point - ellipsoid.centre);
    return local.cwiseQuotient(ellipsoid.radii).squaredNorm() <= 1;
}

std::vector<std::string> validate(const Ellipsoid& ellipsoid) {
    std::vector<std::string> problems;
    if (!ellipsoid.centre.allFinite()) problems.emplace_back("the centre must be three finite numbers");
    if (!ellipsoid.radii.allFinite() || !(ellipsoid.radii.minCoeff() > 0))
        problems.emplace_back("the three radii must be above 0 m");
    if (!(std::abs(ellipsoid.orientation.norm() - 1) < 1e-6))
        problems.emplace_back("the orientation must be a rotation");
    return problems;
}

} // namespace esm

#include "core/geometry/ellipsoid.h"

namespace esm {

bool contains(const Ellipsoid& ellipsoid, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = ellipsoid.orientation.conjugate() * (point - ellipsoid.centre);
    return local.cwiseQuotient(ellipsoid.radii).squaredNorm() <= 1;
}

} // namespace esm

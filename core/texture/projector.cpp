#include "core/texture/projector.h"

namespace esm {

Eigen::Vector3d project(const Projector& projector, const Eigen::Vector3d& point) {
    const Eigen::Vector3d local = projector.pose.inverse() * point;
    return {0.5 + local.x() / projector.width, 0.5 - local.y() / projector.height, -local.z()};
}

} // namespace esm

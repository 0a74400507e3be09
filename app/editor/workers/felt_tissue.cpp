#include "app/editor/workers/felt_tissue.h"

#include <cmath>
#include <limits>

namespace esm {

void ForceMean::add(const Eigen::Vector3d& newtons, double seconds) {
    constexpr double memory = 0.15; // s
    if (!m_mean) m_mean = newtons;
    *m_mean += (1 - std::exp(-seconds / memory)) * (newtons - *m_mean);
}

std::optional<double> ForceMean::size() const {
    return m_mean ? std::optional(m_mean->norm()) : std::nullopt;
}

double displacementAt(const PlacedCollider& collider, const std::vector<Eigen::Vector3d>& rest,
                      const std::vector<Eigen::Vector3d>& positions) {
    const ColliderAxis axis = axisOf(collider);
    double nearest = std::numeric_limits<double>::infinity(), displacement = 0;
    for (std::size_t node = 0; node < positions.size(); ++node) {
        const double distance = (positions[node] - axis.at(axis.nearest(positions[node]))).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        displacement = (positions[node] - rest[node]).norm();
    }
    return displacement;
}

} // namespace esm

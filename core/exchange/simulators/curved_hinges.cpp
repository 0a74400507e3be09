#include "core/exchange/simulators/curved_hinges.h"

#include <algorithm>
#include <cmath>

namespace esm {

bool isCurvedAtRest(const SpringSystem& system) {
    constexpr double rounding = 1e-6; // of the hinge's edge
    const std::vector<Eigen::Vector3d>& places = system.network->restPositions;
    return std::any_of(system.hinges.begin(), system.hinges.end(), [&](const auto& hinge) {
        const double edge = (places[hinge.nodes[0]] - places[hinge.nodes[1]]).norm();
        return std::abs(hinge.restCurvature) * edge > rounding;
    });
}

} // namespace esm

#include "core/dynamics/forces.h"

#include "core/dynamics/hinge_force.h"
#include "core/dynamics/spring_force.h"

#include <utility>

namespace esm {

// What one end gets is taken from the other, the same number: springs add nothing to the momentum of the
// whole.
void elasticForces(const SpringSystem& system, const Vectors& positions, Vectors& forces) {
    forces.assign(positions.size(), Eigen::Vector3d::Zero());
    for (const auto& spring : system.springs) {
        const Eigen::Vector3d force =
            elasticForce(spring, positions[spring.first] - positions[spring.second]);
        forces[spring.first] += force;
        forces[spring.second] -= force;
    }
    for (const auto& hinge : system.hinges)
        addToNodes(hinge, elasticForces(hinge, ofNodes(hinge, positions)), forces);
    const Vectors& rest = system.network->restPositions;
    for (const Tether& tether : system.tethers)
        forces[tether.node] -= tether.springConstant * (positions[tether.node] - rest[tether.node]);
}

void addDampingForces(const SpringSystem& system, Damping damping, const Vectors& positions,
                      const Vectors& velocities, Vectors& forces) {
    for (const auto& spring : system.springs) {
        const Eigen::Vector3d force =
            dampingForce(spring, damping, positions[spring.first] - positions[spring.second],
                         velocities[spring.first] - velocities[spring.second]);
        forces[spring.first] += force;
        forces[spring.second] -= force;
    }
    for (const auto& hinge : system.hinges)
        addToNodes(hinge, dampingForces(hinge, ofNodes(hinge, velocities)), forces);
    for (const Tether& tether : system.tethers)
        forces[tether.node] -= tether.viscosity * velocities[tether.node];
}

Eigen::Vector3d forceOn(const std::vector<std::uint32_t>& nodes, const SpringSystem& system, Damping damping,
                        const Motion& motion) {
    const auto& [positions, velocities] = motion;
    std::vector<char> isMeant(positions.size());
    for (const std::uint32_t node : nodes)
        isMeant[node] = 1;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    // What springs between two of them do cancels.
    for (const auto& spring : system.springs) {
        const auto [first, second] = std::pair(spring.first, spring.second);
        if (isMeant[first] == isMeant[second]) continue;
        const Eigen::Vector3d between = positions[first] - positions[second];
        const Eigen::Vector3d onFirst =
            elasticForce(spring, between) +
            dampingForce(spring, damping, between, velocities[first] - velocities[second]);
        force += isMeant[first] ? onFirst : -onFirst;
    }
    for (const auto& hinge : system.hinges) {
        const HingeVectors elastic = elasticForces(hinge, ofNodes(hinge, positions));
        const HingeVectors viscous = dampingForces(hinge, ofNodes(hinge, velocities));
        for (std::size_t i = 0; i < 4; ++i)
            if (isMeant[hinge.nodes[i]]) force += elastic[i] + viscous[i];
    }
    const Vectors& rest = system.network->restPositions;
    for (const auto& [node, springConstant, viscosity] : system.tethers)
        if (isMeant[node])
            force -= springConstant * (positions[node] - rest[node]) + viscosity * velocities[node];
    return force;
}

Energy energy(const SpringSystem& system, const Vectors& positions, const Vectors& velocities) {
    Energy result;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        result.kinetic += 0.5 * system.mass[i] * velocities[i].squaredNorm();
    for (const auto& spring : system.springs) {
        const double length = (positions[spring.first] - positions[spring.second]).norm();
        result.elastic += elasticEnergy(spring.springConstant, spring.secondPhase, spring.restLength, length);
    }
    for (const auto& hinge : system.hinges)
        result.elastic += elasticEnergy(hinge, ofNodes(hinge, positions));
    const Vectors& rest = system.network->restPositions;
    for (const Tether& tether : system.tethers)
        result.elastic +=
            0.5 * tether.springConstant * (positions[tether.node] - rest[tether.node]).squaredNorm();
    return result;
}

} // namespace esm

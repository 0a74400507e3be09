#include "core/dynamics/forces.h"

namespace esm {

// Force is tension over length times the vector between the ends, so that no direction has to be divided out
// first. What one end gets is taken from the other, the same number: springs add nothing to the momentum of
// the whole.
void elasticForces(const SpringSystem& system, const Vectors& positions, Vectors& forces) {
    forces.assign(positions.size(), Eigen::Vector3d::Zero());
    for (const auto& spring : system.springs) {
        const Eigen::Vector3d between = positions[spring.first] - positions[spring.second];
        const double length = between.norm();
        if (!(length > 0)) continue;
        const Eigen::Vector3d force =
            between * tensionPerLength(spring.springConstant, spring.secondPhase, spring.restLength / length);
        forces[spring.first] -= force;
        forces[spring.second] += force;
    }
    const Vectors& rest = system.network->restPositions;
    for (const Tether& tether : system.tethers)
        forces[tether.node] -= tether.springConstant * (positions[tether.node] - rest[tether.node]);
}

// Of a spring without length the normalised direction is zero, and so is its axial damping: it has no axis.
void addDampingForces(const SpringSystem& system, Damping damping, const Vectors& positions,
                      const Vectors& velocities, Vectors& forces) {
    for (const auto& spring : system.springs) {
        Eigen::Vector3d approach = velocities[spring.first] - velocities[spring.second];
        if (damping == Damping::Axial) {
            const Eigen::Vector3d direction =
                (positions[spring.first] - positions[spring.second]).normalized();
            approach = direction * direction.dot(approach);
        }
        const Eigen::Vector3d force = spring.viscosity * approach;
        forces[spring.first] -= force;
        forces[spring.second] += force;
    }
    for (const Tether& tether : system.tethers)
        forces[tether.node] -= tether.viscosity * velocities[tether.node];
}

Energy energy(const SpringSystem& system, const Vectors& positions, const Vectors& velocities) {
    Energy result;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        result.kinetic += 0.5 * system.mass[i] * velocities[i].squaredNorm();
    for (const auto& spring : system.springs) {
        const double length = (positions[spring.first] - positions[spring.second]).norm();
        result.elastic += elasticEnergy(spring.springConstant, spring.secondPhase, spring.restLength, length);
    }
    const Vectors& rest = system.network->restPositions;
    for (const Tether& tether : system.tethers)
        result.elastic +=
            0.5 * tether.springConstant * (positions[tether.node] - rest[tether.node]).squaredNorm();
    return result;
}

} // namespace esm

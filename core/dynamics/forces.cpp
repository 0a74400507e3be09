#include "core/dynamics/forces.h"

#include "core/dynamics/hinge_force.h"
#include "core/dynamics/spring_force.h"

#include <cmath>
#include <utility>

namespace esm {

namespace {

CavityVolume volumeAt(const SpringSystem::Filled& cavity, const Vectors& positions) {
    return volumeOf(*cavity.wall, placesOf(*cavity.wall, positions));
}

void addGradient(const SpringSystem::Filled& cavity, double pressure, const Vectors& gradient,
                 Vectors& forces) {
    for (std::size_t place = 0; place < gradient.size(); ++place)
        forces[cavity.wall->nodes[place]] += pressure * gradient[place];
}

void addOwnPressures(const SpringSystem& system, const Vectors& positions, Vectors& forces) {
    for (const SpringSystem::Filled& cavity : system.cavities) {
        if (cavity.stiffness == 0) continue;
        const auto [volume, gradient] = volumeAt(cavity, positions);
        addGradient(cavity, ownPressure(cavity, volume), gradient, forces);
    }
}

} // namespace

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
    addOwnPressures(system, positions, forces);
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

double pressureOfLoads(const Loads& loads, const SpringSystem::Filled& cavity, double endShare) {
    for (const CavityPressure& pressure : loads.pressures)
        if (pressure.part == cavity.part) return (1 - endShare) * pressure.before + endShare * pressure.after;
    return 0;
}

void addPressureOfLoads(const SpringSystem& system, const Loads& loads, double endShare,
                        const Vectors& positions, Vectors& forces) {
    for (const SpringSystem::Filled& cavity : system.cavities)
        if (const double pressure = pressureOfLoads(loads, cavity, endShare); pressure != 0)
            addGradient(cavity, pressure, volumeAt(cavity, positions).gradient, forces);
}

void addFluidForces(const SpringSystem& system, const Loads& loads, double endShare, const Vectors& positions,
                    Vectors& forces) {
    addOwnPressures(system, positions, forces);
    addPressureOfLoads(system, loads, endShare, positions, forces);
}

double workOfPressures(const SpringSystem& system, const Loads& loads, const Vectors& from,
                       const Vectors& to) {
    double work = 0;
    for (const SpringSystem::Filled& cavity : system.cavities)
        if (const double pressure = pressureOfLoads(loads, cavity, 0.5); pressure != 0)
            work += pressure * (volumeAt(cavity, to).volume - volumeAt(cavity, from).volume);
    return work;
}

std::vector<double> volumesOf(const SpringSystem& system, const Vectors& positions) {
    std::vector<double> volumes;
    for (const SpringSystem::Filled& cavity : system.cavities)
        volumes.push_back(volumeAt(cavity, positions).volume);
    return volumes;
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
    for (const SpringSystem::Filled& cavity : system.cavities) {
        const auto [volume, gradient] = volumeAt(cavity, positions);
        for (std::size_t place = 0; place < gradient.size(); ++place)
            if (isMeant[cavity.wall->nodes[place]]) force += ownPressure(cavity, volume) * gradient[place];
    }
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
    for (const SpringSystem::Filled& cavity : system.cavities)
        if (cavity.stiffness > 0)
            result.elastic += 0.5 * pressureSlope(cavity) *
                              std::pow(volumeAt(cavity, positions).volume - cavity.restVolume, 2);
    return result;
}

} // namespace esm

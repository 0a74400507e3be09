#include "core/dynamics/statics/resting_potential.h"

#include "core/dynamics/fluid_entries.h"
#include "core/dynamics/forces.h"
#include "core/dynamics/hinge_entries.h"
#include "core/dynamics/spring_force.h"

namespace esm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d differenceOf(const SpringSystem::Element& spring, const Vectors& vectors) {
    return vectors[spring.first] - vectors[spring.second];
}

/// m, from where each node would be without forces.
Vector3d offCourse(const TimeLapse& lapse, const Vectors& positions, std::size_t node) {
    return positions[node] - lapse.before.positions[node] - lapse.duration * lapse.before.velocities[node];
}

/// m, by which a hinge's bars have moved against each other.
Vector3d turned(const SpringSystem::HingeElement& hinge, const Vectors& before, const Vectors& after) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i)
        sum += hinge.weights[i] * (after[hinge.nodes[i]] - before[hinge.nodes[i]]);
    return sum;
}

} // namespace

double RestingPotential::value(const Vectors& positions) const {
    double value = energy(m_system, positions, {}).elastic -
                   workOfPressures(m_system, m_loads, m_system.network->restPositions, positions);
    if (!m_lapse) return value;
    const auto& [duration, before] = *m_lapse;
    for (std::size_t i = 0; i < positions.size(); ++i)
        value +=
            0.5 * m_system.mass[i] / (duration * duration) * offCourse(*m_lapse, positions, i).squaredNorm();
    for (const auto& spring : m_system.springs)
        value += 0.5 * spring.viscosity / duration *
                 (differenceOf(spring, positions) - differenceOf(spring, before.positions)).squaredNorm();
    for (const auto& hinge : m_system.hinges)
        value += 0.5 * hinge.viscosity / duration * turned(hinge, before.positions, positions).squaredNorm();
    for (const Tether& tether : m_system.tethers)
        value += 0.5 * tether.viscosity / duration *
                 (positions[tether.node] - before.positions[tether.node]).squaredNorm();
    return value;
}

void RestingPotential::forces(const Vectors& positions, Vectors& forces) const {
    elasticForces(m_system, positions, forces);
    addPressureOfLoads(m_system, m_loads, 0, positions, forces);
    if (m_lapse) {
        const auto& [duration, before] = *m_lapse;
        Vectors velocities(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = (positions[i] - before.positions[i]) / duration;
            forces[i] -= m_system.mass[i] / (duration * duration) * offCourse(*m_lapse, positions, i);
        }
        addDampingForces(m_system, Damping::Isotropic, positions, velocities, forces);
    }
    for (std::size_t i = 0; i < forces.size(); ++i)
        if (m_system.fixed[i]) forces[i].setZero();
}

void RestingPotential::addStiffness(const Vectors& positions, BlockEntries& entries) const {
    const double rate = m_lapse ? 1 / m_lapse->duration : 0;
    for (const auto& spring : m_system.springs) {
        const auto [direction, axial, lateral] = tangentOf(spring, differenceOf(spring, positions));
        const Matrix3d along = direction * direction.transpose();
        entries.addBetween(spring.first, spring.second,
                           (lateral + rate * spring.viscosity) * (Matrix3d::Identity() - along) +
                               (axial + rate * spring.viscosity) * along);
    }
    for (const auto& hinge : m_system.hinges)
        addHinge(hinge, positions, HingeTangent::WithStrain, {0, rate, 1}, entries);
    for (const Tether& tether : m_system.tethers)
        entries.add(tether.node, tether.node,
                    (tether.springConstant + rate * tether.viscosity) * Matrix3d::Identity());
    for (const SpringSystem::Filled& cavity : m_system.cavities) {
        const Vectors places = placesOf(*cavity.wall, positions);
        const double own = ownPressure(cavity, volumeOf(*cavity.wall, places).volume);
        addTurning(cavity, own + pressureOfLoads(m_loads, cavity, 0), places, entries);
    }
    if (rate == 0) return;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        entries.add(i, i, rate * rate * m_system.mass[i] * Matrix3d::Identity());
}

std::vector<double> RestingPotential::nodeStiffness() const {
    const double rate = m_lapse ? 1 / m_lapse->duration : 0;
    std::vector<double> sums(m_system.mass.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] = rate * rate * m_system.mass[i];
    for (const auto& spring : m_system.springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            sums[node] += largestSpringConstant(spring) + rate * spring.viscosity;
    for (const auto& hinge : m_system.hinges)
        for (std::size_t i = 0; i < 4; ++i)
            sums[hinge.nodes[i]] +=
                hinge.weights[i] * hinge.weights[i] * (largestSpringConstant(hinge) + rate * hinge.viscosity);
    for (const Tether& tether : m_system.tethers)
        sums[tether.node] += tether.springConstant + rate * tether.viscosity;
    return sums;
}

Vectors restPlacesOfRows(const SpringSystem& system) {
    Vectors places;
    for (std::size_t node = 0; node < system.fixed.size(); ++node)
        if (!system.fixed[node]) places.insert(places.end(), 3, system.network->restPositions[node]);
    return places;
}

} // namespace esm

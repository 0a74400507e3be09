#include "core/dynamics/measure/energy_watch.h"

#include "core/dynamics/forces.h"
#include "core/dynamics/hinge_force.h"
#include "core/dynamics/spring_force.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

constexpr double allowedShare = 0.25;    ///< of the work that went in or out, and of what was held before
constexpr std::size_t stepsPerLook = 64; ///< of an explicit integrator; a look costs about two of them: 3 %
constexpr std::size_t solvesPerLook = 8; ///< a step that solves costs far more than a look

/// J, of all springs when each of their ends is off by a rounding of the largest coordinate. Stiff tissue at
/// rest would else be found to hold energy that nobody gave it: in single precision far from the origin that
/// can be more than its loads do.
double roundingEnergyOf(const SpringSystem& system, Precision precision, const Vectors& positions) {
    double size = 0, stiffness = 0;
    for (const Eigen::Vector3d& position : positions)
        size = std::max(size, position.cwiseAbs().maxCoeff());
    for (const SpringSystem::Element& spring : system.springs)
        stiffness += largestSpringConstant(spring);
    for (const auto& hinge : system.hinges)
        stiffness += hinge.springConstant;
    for (const Tether& tether : system.tethers)
        stiffness += tether.springConstant;
    const double relative = precision == Precision::Float ? std::numeric_limits<float>::epsilon()
                                                          : std::numeric_limits<double>::epsilon();
    return stiffness / 2 * std::pow(2 * relative * size, 2);
}

Vectors moved(const Vectors& positions, double time, const Vectors& velocities) {
    Vectors result = positions;
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += time * velocities[i];
    return result;
}

double elasticEnergyOf(const SpringSystem& system, const Vectors& positions) {
    return energy(system, positions, {}).elastic;
}

/// J, of forces, pressures and gravity on the way between two places.
double workOfForces(const SpringSystem& system, const Loads& loads, const Vectors& from, const Vectors& to) {
    double work = workOfPressures(system, loads, from, to);
    for (const auto& [node, force] : loads.forces)
        work += force.dot(to[node] - from[node]);
    if (!loads.gravity.isZero(0))
        for (std::size_t i = 0; i < to.size(); ++i)
            work += system.mass[i] * loads.gravity.dot(to[i] - from[i]);
    return work;
}

/// N, of springs, hinges and tethers.
Vectors innerForces(const SpringSystem& system, Damping damping, const Motion& motion) {
    Vectors forces;
    elasticForces(system, motion.positions, forces);
    addDampingForces(system, damping, motion.positions, motion.velocities, forces);
    return forces;
}

/// A step as it is seen in the middle of its time: the places before and after it, m, and the velocities
/// between them, m/s.
struct MiddleStep {
    Vectors from, to, velocities;
    double viscousTime; ///< s, the share of the step by which viscosity adds to the inertia
};

/// With the viscosity D at a step's end, (M + h·D)·v⁺ = M·v − h·K·x lowers ½·v²·(M + h·D/2) + ½·x⁻·K·x⁺ by
/// h·D/4·(v + v⁺)² in every step; with D at its beginning the sign before h·D/2 is the other.
MiddleStep stepBefore(const WatchedSteps& last, Integrator integrator) {
    const Motion& motion = last.after;
    const double half = last.duration / 2;
    return {moved(motion.positions, -last.duration, motion.velocities), motion.positions, motion.velocities,
            isExplicit(integrator) ? -half : half};
}

/// Verlet's next one, as long as the last.
MiddleStep stepAfter(const SpringSystem& system, Damping damping, const WatchedSteps& last) {
    const Motion& motion = last.after;
    Vectors forces = innerForces(system, damping, motion);
    addExternalForces(system, last.loads, forces);
    addPressureOfLoads(system, last.loads, 1, motion.positions, forces);
    Vectors velocities = motion.velocities;
    for (std::size_t i = 0; i < velocities.size(); ++i)
        if (!system.fixed[i]) velocities[i] += last.duration / 2 / system.mass[i] * forces[i];
    for (const PrescribedNode& led : last.loads.prescribed)
        velocities[led.node] = motion.velocities[led.node];
    Vectors to = moved(motion.positions, last.duration, velocities);
    return {motion.positions, std::move(to), std::move(velocities), 0};
}

// Of linear springs the middle energy is ½·x⁻ᵀ·K·x⁺. Of others it is half of both ends' energies, less
// ¼·ΔxᵀKΔx, where KΔx is what the forces change by: for linear ones that is the same.
double middleEnergy(const SpringSystem& system, Damping damping, const WatchedSteps& last,
                    const MiddleStep& step) {
    Vectors forces, forcesBefore, viscous(step.velocities.size(), Eigen::Vector3d::Zero());
    elasticForces(system, step.to, forces);
    elasticForces(system, step.from, forcesBefore);
    addDampingForces(system, damping, step.from, step.velocities, viscous);
    Vectors middle = step.from;
    double between = 0, heat = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        middle[i] = (step.from[i] + step.to[i]) / 2;
        between += (forces[i] - forcesBefore[i]).dot(step.to[i] - step.from[i]);
        heat -= viscous[i].dot(step.velocities[i]);
    }
    const double kinetic = energy(system, last.after.positions, step.velocities).kinetic;
    const double elastic = (elasticEnergyOf(system, step.from) + elasticEnergyOf(system, step.to)) / 2;
    return kinetic + step.viscousTime / 2 * heat + elastic + between / 4 -
           workOfForces(system, last.loads, last.after.positions, middle);
}

} // namespace

double keptEnergy(const SpringSystem& system, Integrator integrator, Damping damping,
                  const WatchedSteps& steps) {
    switch (traitsOf(integrator).keptEnergy) {
    case KeptEnergy::InStepBefore:
        return middleEnergy(system, damping, steps, stepBefore(steps, integrator));
    case KeptEnergy::InStepAfter:
        return middleEnergy(system, damping, steps, stepAfter(system, damping, steps));
    case KeptEnergy::AtEnd:
        break;
    }
    return energy(system, steps.after.positions, steps.after.velocities).total();
}

EnergyWatch::EnergyWatch(const SpringSystem& system, const SimulationSettings& settings, const Motion& start)
    : m_system(system), m_integrator(settings.integrator), m_damping(settings.damping),
      m_startEnergy(energy(system, start.positions, start.velocities).total()),
      m_roundingEnergy(roundingEnergyOf(system, settings.precision, start.positions)) {}

void EnergyWatch::add(const WatchedSteps& steps) {
    const double forces = workOfForces(m_system, steps.loads, steps.before.positions, steps.after.positions);
    const double leading = steps.loads.prescribed.empty() ? 0 : workOfLeading(steps);
    m_work += forces + leading + steps.contactWork;
    m_grossWork += std::abs(forces) + std::abs(leading) + std::abs(steps.contactWork);
    m_steps += steps.count;
}

bool EnergyWatch::isDue() const {
    return m_steps - m_lookedAt >= (isExplicit(m_integrator) ? stepsPerLook : solvesPerLook);
}

// What may be held is the loads' work with a margin on all that passed to and fro, not on what is left of it:
// a load that pushes and pulls in turn may leave next to nothing, while its steps were inexact by a part of
// each push.
std::string EnergyWatch::look(const WatchedSteps& steps) {
    m_lookedAt = m_steps;
    const double held = keptEnergy(m_system, m_integrator, m_damping, steps) - m_startEnergy;
    const double rounding = m_roundingEnergy * static_cast<double>(m_steps);
    if (held <= m_work + allowedShare * (m_grossWork + m_startEnergy) + rounding) return {};
    return "the steps make energy out of nothing: the tissue holds " + roundedText(held, 2) +
           " J more than at its start, of which its loads gave " + roundedText(m_work, 2) +
           " J; a shorter step is needed";
}

// The whole of what takes a led node along its way: its gain of kinetic energy, less the work that springs,
// tethers and other loads do on it. Elastic forces are a mean of both ends; those of viscosity are taken at
// the end, since a node that begins to move drags what is viscous along from the first moment.
double EnergyWatch::workOfLeading(const WatchedSteps& steps) {
    if (!m_ties) m_ties.emplace(m_system);
    const Motion &before = steps.before, &after = steps.after;
    double work = 0;
    for (const PrescribedNode& led : steps.loads.prescribed) {
        const std::uint32_t node = led.node;
        if (m_system.fixed[node]) continue;
        Eigen::Vector3d force = innerForceOn(node, after.positions, after.velocities);
        force += (innerForceOn(node, before.positions, {}) - innerForceOn(node, after.positions, {})) / 2;
        force += m_system.mass[node] * steps.loads.gravity;
        for (const auto& [pulled, external] : steps.loads.forces)
            if (pulled == node) force += external;
        const double gained = after.velocities[node].squaredNorm() - before.velocities[node].squaredNorm();
        work += m_system.mass[node] * gained / 2 - force.dot(after.positions[node] - before.positions[node]);
    }
    return work - workOfFluidsOnLed(steps);
}

/// J, that fluids do on the led nodes, by the mean of their forces at both ends of the steps.
double EnergyWatch::workOfFluidsOnLed(const WatchedSteps& steps) const {
    if (m_system.cavities.empty()) return 0;
    Vectors sums(steps.after.positions.size(), Eigen::Vector3d::Zero());
    addFluidForces(m_system, steps.loads, 0, steps.before.positions, sums);
    addFluidForces(m_system, steps.loads, 1, steps.after.positions, sums);
    double work = 0;
    for (const PrescribedNode& led : steps.loads.prescribed)
        if (!m_system.fixed[led.node])
            work +=
                sums[led.node].dot(steps.after.positions[led.node] - steps.before.positions[led.node]) / 2;
    return work;
}

/// N, without velocities the elastic part alone.
Eigen::Vector3d EnergyWatch::innerForceOn(std::uint32_t node, const Vectors& positions,
                                          const Vectors& velocities) const {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const auto& [other, number] : m_ties->springsOf(node)) {
        const SpringSystem::Element& spring = m_system.springs[number];
        const Eigen::Vector3d between = positions[node] - positions[other];
        force += elasticForce(spring, between);
        if (!velocities.empty())
            force += dampingForce(spring, m_damping, between, velocities[node] - velocities[other]);
    }
    for (const auto& [number, place] : m_ties->hingesOf(node)) {
        const auto& hinge = m_system.hinges[number];
        force += elasticForces(hinge, ofNodes(hinge, positions))[place];
        if (!velocities.empty()) force += dampingForces(hinge, ofNodes(hinge, velocities))[place];
    }
    const Tether& tether = m_ties->tetherOf(node);
    force -= tether.springConstant * (positions[node] - m_system.network->restPositions[node]);
    if (!velocities.empty()) force -= tether.viscosity * velocities[node];
    return force;
}

} // namespace esm

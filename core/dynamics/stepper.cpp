#include "core/dynamics/stepper.h"

#include "core/dynamics/forces.h"

#include <algorithm>

namespace esm {

namespace {

/// Above this, leading nodes through their responses to each other costs more than a factorisation without
/// them.
constexpr std::size_t mostLedByImpulses = 64;

/// The last place given for each node that is free to follow, in the order of nodes.
std::vector<HeldNode> movable(std::vector<HeldNode> held, const std::vector<char>& fixed) {
    std::stable_sort(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    std::vector<HeldNode> result;
    for (const HeldNode& node : held) {
        if (fixed[node.node]) continue;
        if (!result.empty() && result.back().node == node.node) result.pop_back();
        result.push_back(node);
    }
    return result;
}

} // namespace

Stepper::Stepper(SpringSystem system, std::vector<Triangle> surface, const ChosenStep& chosen,
                 Damping damping)
    : m_system(std::move(system)), m_surface(std::move(surface)), m_integrator(chosen.integrator),
      m_timeStep(chosen.timeStep), m_damping(damping), m_prescribed(m_system.fixed) {
    solverFor({m_timeStep, 1, nullptr, {}}, false);
    if (m_integrator == Integrator::Split2) solverFor({m_timeStep, 1, nullptr, {}}, true);
}

void Stepper::restart() {
    m_lastLoads.reset();
    m_previous.reset();
}

void Stepper::step(Motion& motion, const Loads& loads) {
    if (!m_lastLoads || m_lastLoads->gravity != loads.gravity || m_lastLoads->forces != loads.forces)
        m_previous.reset();
    advance(motion, {m_timeStep, 1, &loads, movable(loads.held, m_system.fixed)});
    m_lastLoads = loads;
}

void Stepper::advance(Motion& motion, const Piece& piece) {
    prescribe(piece.held);
    elasticForces(m_system, motion.positions, m_forces);
    const bool secondOrder = m_integrator == Integrator::Split2 && m_previous && piece.held.empty();
    Motion next = motion;
    solve(motion, piece, secondOrder, next);
    m_previous = std::exchange(motion, std::move(next));
    m_previousForces.swap(m_forces);
    if (!piece.held.empty()) m_previous.reset();
}

void Stepper::solve(const Motion& motion, const Piece& piece, bool secondOrder, Motion& next) {
    Solver& solver = solverFor(piece, secondOrder);
    const double h = piece.duration;
    std::vector<std::uint32_t> led;
    for (const HeldNode& held : piece.held) {
        next.velocities[held.node] = (held.position - motion.positions[held.node]) / h;
        if (!solver.matrix.isPrescribed(held.node)) led.push_back(held.node);
    }
    Vectors half;
    solver.matrix.solveLower(momentum(motion, piece, secondOrder), next.velocities, half);
    if (!led.empty()) solver.impulses.lead(led, next.velocities, half);
    solver.matrix.solveUpper(half, next.velocities);

    for (std::size_t i = 0; i < next.positions.size(); ++i) {
        // Written as a change, so that what rests stays where it is to the last bit.
        const Eigen::Vector3d change = h * next.velocities[i];
        next.positions[i] +=
            secondOrder ? ((motion.positions[i] - m_previous->positions[i]) + 2 * change) / 3 : change;
    }
    for (const HeldNode& held : piece.held)
        next.positions[held.node] = held.position;
}

Vectors Stepper::momentum(const Motion& motion, const Piece& piece, bool secondOrder) const {
    const double h = piece.duration;
    Vectors forces = m_forces;
    if (secondOrder)
        for (std::size_t i = 0; i < forces.size(); ++i)
            forces[i] = 2 * forces[i] - m_previousForces[i];
    if (m_integrator == Integrator::Euler)
        addDampingForces(m_system, m_damping, motion.positions, motion.velocities, forces);
    for (const auto& [node, force] : piece.loads->forces)
        forces[node] += force;

    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Eigen::Vector3d velocity =
            secondOrder ? 2 * motion.velocities[i] - 0.5 * m_previous->velocities[i] : motion.velocities[i];
        forces[i] = m_system.mass[i] * (velocity + h * piece.loads->gravity) + h * forces[i];
    }
    return forces;
}

Stepper::Solver& Stepper::solverFor(const Piece& piece, bool secondOrder) {
    std::unique_ptr<Solver>& solver = m_solvers[{piece.part, secondOrder}];
    if (!solver) {
        const double damping = m_integrator == Integrator::Euler ? 0 : piece.duration;
        solver =
            std::make_unique<Solver>(StepMatrix(m_system, secondOrder ? 1.5 : 1.0, damping, m_prescribed));
    }
    return *solver;
}

void Stepper::prescribe(const std::vector<HeldNode>& held) {
    std::vector<char> prescribed = m_system.fixed;
    if (held.size() > mostLedByImpulses)
        for (const HeldNode& node : held)
            prescribed[node.node] = 1;
    if (prescribed == m_prescribed) return;
    m_prescribed = std::move(prescribed);
    m_solvers.clear();
}

} // namespace esm

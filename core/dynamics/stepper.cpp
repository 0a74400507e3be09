#include "core/dynamics/stepper.h"

#include "core/dynamics/contact_impulses.h"
#include "core/dynamics/forces.h"

#include <algorithm>

namespace esm {

namespace {

/// Above this, leading nodes through their responses to each other costs more than a factorisation without
/// them.
constexpr std::size_t mostLedByImpulses = 64;

/// What touches beyond this is pushed out one by one, without dragging along what is around it.
constexpr std::size_t mostContacts = 256;
constexpr int mostContactRounds = 3;
constexpr double contactTolerance = 1e-3; ///< in radii; the rest is projected out
constexpr double impulseTolerance = 1e-5; ///< in radii

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
    solverFor(1, false);
    if (m_integrator == Integrator::Split2) solverFor(1, true);
}

void Stepper::restart() {
    m_lastLoads.reset();
    m_previous.reset();
}

void Stepper::step(Motion& motion, const Loads& loads, const std::optional<SphereMove>& sphere) {
    if (!m_lastLoads || m_lastLoads->gravity != loads.gravity || m_lastLoads->forces != loads.forces)
        m_previous.reset();
    m_touched = false;
    for (const Piece& piece : piecesOf(motion, loads, sphere))
        advance(motion, piece);
    m_lastLoads = loads;
}

std::vector<Stepper::Piece> Stepper::piecesOf(const Motion& motion, const Loads& loads,
                                              const std::optional<SphereMove>& sphere) const {
    const std::vector<HeldNode> held = movable(loads.held, m_system.fixed);
    if (!sphere || m_surface.empty()) return {{m_timeStep, 1, &loads, held, {}}};
    Vectors velocities = motion.velocities;
    for (const HeldNode& node : held)
        velocities[node.node] = (node.position - motion.positions[node.node]) / m_timeStep;
    const int parts = contactParts(m_surface, motion.positions, velocities, *sphere, m_timeStep);

    std::vector<Piece> pieces;
    const auto& [from, to, radius] = *sphere;
    Eigen::Vector3d reached = from;
    for (int part = 1; part <= parts; ++part) {
        const double fraction = static_cast<double>(part) / parts;
        Piece piece{m_timeStep / parts, parts, &loads, held, {}};
        for (HeldNode& node : piece.held) {
            const Eigen::Vector3d& start = motion.positions[node.node];
            if (part < parts) node.position = start + fraction * (node.position - start);
        }
        const Eigen::Vector3d next = part < parts ? Eigen::Vector3d(from + fraction * (to - from)) : to;
        piece.sphere = SphereMove{std::exchange(reached, next), next, radius};
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

void Stepper::advance(Motion& motion, const Piece& piece) {
    prescribe(piece.held);
    elasticForces(m_system, motion.positions, m_forces);
    const bool secondOrder =
        m_integrator == Integrator::Split2 && m_previous && piece.held.empty() && piece.parts == 1;
    Motion next = motion;
    Untouched untouched = solve(motion, piece, secondOrder, next);
    const bool touched = touches(motion, piece, next);
    m_touched = m_touched || touched;
    if (touched && secondOrder) {
        next = motion;
        untouched = solve(motion, piece, false, next);
    }
    if (touched) makeWay(motion, piece, untouched, next);

    m_previous = std::exchange(motion, std::move(next));
    m_previousForces.swap(m_forces);
    if (touched || !piece.held.empty() || piece.parts > 1) m_previous.reset();
}

Stepper::Untouched Stepper::solve(const Motion& motion, const Piece& piece, bool secondOrder, Motion& next) {
    Solver& solver = solverFor(piece.parts, secondOrder);
    Untouched untouched;
    for (const HeldNode& held : piece.held) {
        next.velocities[held.node] = (held.position - motion.positions[held.node]) / piece.duration;
        if (!solver.matrix.isPrescribed(held.node)) untouched.led.push_back(held.node);
    }
    solver.matrix.solveLower(momentum(motion, piece, secondOrder), next.velocities, untouched.half);
    if (!untouched.led.empty()) solver.impulses.lead(untouched.led, next.velocities, untouched.half);
    solver.matrix.solveUpper(untouched.half, next.velocities);
    moveOn(motion, piece, secondOrder, next);
    return untouched;
}

void Stepper::moveOn(const Motion& motion, const Piece& piece, bool secondOrder, Motion& next) const {
    for (std::size_t i = 0; i < next.positions.size(); ++i) {
        // Written as a change, so that what rests stays where it is to the last bit.
        const Eigen::Vector3d change = piece.duration * next.velocities[i];
        next.positions[i] =
            motion.positions[i] +
            (secondOrder
                 ? Eigen::Vector3d(((motion.positions[i] - m_previous->positions[i]) + 2 * change) / 3)
                 : change);
    }
    for (const HeldNode& held : piece.held)
        next.positions[held.node] = held.position;
}

std::vector<char> Stepper::immovable(const Piece& piece) const {
    std::vector<char> result = m_prescribed;
    for (const HeldNode& held : piece.held)
        result[held.node] = 1;
    return result;
}

bool Stepper::touches(const Motion& motion, const Piece& piece, const Motion& next) const {
    return piece.sphere &&
           !findContacts(m_surface, immovable(piece), motion.positions, next.positions, *piece.sphere)
                .empty();
}

// Each round solves anew from the untouched step, with the contacts of the rounds before, turned to where the
// surface came to lie, and those that were found since: nothing is pushed twice.
void Stepper::makeWay(const Motion& motion, const Piece& piece, const Untouched& untouched, Motion& next) {
    Solver& solver = solverFor(piece.parts, false);
    const SphereMove& sphere = *piece.sphere;
    const std::vector<char> stays = immovable(piece);
    const Vectors free = next.positions;
    std::vector<Contact> contacts;
    Eigen::VectorXd impulses;
    for (int round = 0; round < mostContactRounds; ++round) {
        const auto found = findContacts(m_surface, stays, motion.positions, next.positions, sphere);
        if (round > 0 && deepest(found) <= contactTolerance * sphere.radius) break;
        mergeContacts(contacts, found, mostContacts);
        Eigen::VectorXd needed(contacts.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            turnOutward(contacts[i], motion.positions, next.positions, sphere);
            needed[static_cast<Eigen::Index>(i)] = depth(contacts[i], free, sphere) / piece.duration;
        }
        impulses.conservativeResizeLike(Eigen::VectorXd::Zero(needed.size()));
        Vectors half = untouched.half;
        const double tolerance = impulseTolerance * sphere.radius / piece.duration;
        pushContacts({contacts, needed, untouched.led, stays, tolerance}, solver.impulses, impulses, half);
        solver.matrix.solveUpper(std::move(half), next.velocities);
        moveOn(motion, piece, false, next);
    }
    const Vectors solved = next.positions;
    projectOut(m_surface, stays, motion.positions, sphere, next.positions);
    for (std::size_t i = 0; i < solved.size(); ++i)
        next.velocities[i] += (next.positions[i] - solved[i]) / piece.duration;
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

Stepper::Solver& Stepper::solverFor(int parts, bool secondOrder) {
    std::unique_ptr<Solver>& solver = m_solvers[{parts, secondOrder}];
    if (!solver) {
        const double damping = m_integrator == Integrator::Euler ? 0 : m_timeStep / parts;
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

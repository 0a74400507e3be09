#include "core/dynamics/schemes/stepper.h"

#include "core/dynamics/contact/contact_impulses.h"
#include "core/dynamics/forces.h"
#include "core/dynamics/schemes/fluid_answers.h"
#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/schemes/told_impulses.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// What touches beyond this is pushed out one by one, without dragging along what is around it.
constexpr std::size_t mostContacts = 256;
constexpr int mostContactRounds = 3;
constexpr double contactTolerance = 1e-3; ///< in radii; the rest is projected out
constexpr double impulseTolerance = 1e-5; ///< in radii

/// Of the larger of two velocities, what smooth ways change from step to step.
constexpr double smoothChange = 0.5;

bool isJump(const Eigen::Vector3d& before, const Eigen::Vector3d& now) {
    const double larger = std::max(before.squaredNorm(), now.squaredNorm());
    return (now - before).squaredNorm() > smoothChange * smoothChange * larger;
}

/// Whether pressures go on from where they were. What is not named is none.
bool goOn(const std::vector<CavityPressure>& before, const std::vector<CavityPressure>& now) {
    constexpr double rounding = 1e-9;
    const auto continues = [](const CavityPressure& was, const CavityPressure& is) {
        const double larger = std::max(std::abs(was.after), std::abs(is.before));
        return was.part == is.part && std::abs(is.before - was.after) <= rounding * larger;
    };
    return std::equal(before.begin(), before.end(), now.begin(), now.end(), continues);
}

/// The last place given for each node that is free to follow, in the order of nodes.
std::vector<PrescribedNode> movable(std::vector<PrescribedNode> prescribed, const std::vector<char>& fixed) {
    std::stable_sort(prescribed.begin(), prescribed.end(),
                     [](const auto& a, const auto& b) { return a.node < b.node; });
    std::vector<PrescribedNode> result;
    for (const PrescribedNode& node : prescribed) {
        if (fixed[node.node]) continue;
        if (!result.empty() && result.back().node == node.node) result.pop_back();
        result.push_back(node);
    }
    return result;
}

/// Of those that touch, the finest tolerance, m.
double impulseToleranceOf(const std::vector<Contact>& contacts, const std::vector<ColliderMove>& colliders) {
    double least = std::numeric_limits<double>::infinity();
    for (const Contact& contact : contacts)
        least = std::min(least, radiusOf(colliders[contact.collider].shape));
    return impulseTolerance * least;
}

bool joinTheSame(const std::vector<SpringSystem::HingeElement>& hinges,
                 const std::vector<SpringSystem::HingeElement>& others) {
    return std::equal(hinges.begin(), hinges.end(), others.begin(), others.end(),
                      [](const auto& a, const auto& b) { return a.nodes == b.nodes; });
}

/// s, the longest stable step of symplectic Euler: at any deformation, where the integrator's own step is
/// stable at any; else close to rest, since the step was given and is taken as it is.
double longestEulerStep(const SpringSystem& system, Damping damping, Integrator integrator, double timeStep) {
    constexpr double tolerance = 0.05;
    TissueSpectrum strained(system, damping, {tolerance, Deformation::Any, {}});
    if (schemeOf(integrator).largestStable(strained, timeStep).value_or(0) >= timeStep)
        return *schemeOf(Integrator::Euler).largestStable(strained, noStepLimit);
    TissueSpectrum resting(system, damping, {tolerance, Deformation::AtRest, {}});
    return *schemeOf(Integrator::Euler).largestStable(resting, noStepLimit);
}

} // namespace

Stepper::Stepper(PreparedModel model, TouchedSurface surface, ThreadTeam* team, const Stepper* former)
    : m_system(std::move(model.system)), m_surface(std::move(surface)), m_settings(std::move(model.settings)),
      m_team(team), m_integrator(model.chosen.integrator), m_timeStep(model.chosen.timeStep),
      m_duration(model.chosen.timeStep), m_solvers(m_system, m_integrator, std::move(model.solvers)),
      m_scheme(makeScheme(former)) {
    if (former) m_solvers.takeOver(former->m_solvers);
}

bool Stepper::canTakeScheme(const Stepper& former) const {
    const SimulationSettings &settings = m_settings, &others = former.m_settings;
    return m_integrator == former.m_integrator && m_system.network == former.m_system.network &&
           joinTheSame(m_system.hinges, former.m_system.hinges) && m_team == former.m_team &&
           settings.damping == others.damping && settings.precision == others.precision &&
           settings.restTolerance == others.restTolerance;
}

std::unique_ptr<StepScheme> Stepper::makeScheme(const Stepper* former) const {
    if (former && canTakeScheme(*former))
        if (auto taken = former->m_scheme->withParameters(m_system)) return taken;
    return makeStepScheme(m_system, m_integrator, m_settings, m_team);
}

void Stepper::restart() {
    m_lastLoads.reset();
    m_scheme->restart();
}

bool Stepper::touchesNothing(const Loads& loads) const {
    return isExplicit(m_integrator) && loads.prescribed.empty() &&
           (loads.instruments.empty() || m_surface.empty());
}

void Stepper::steps(Motion& motion, const Request& request) {
    const Loads& loads = request.loads;
    if (!m_lastLoads || m_lastLoads->gravity != loads.gravity || m_lastLoads->forces != loads.forces ||
        !goOn(m_lastLoads->pressures, loads.pressures) ||
        lengthOf(m_duration) != lengthOf(request.duration) || loads.beginsAnew)
        m_scheme->restart();
    m_duration = request.duration;
    m_touches.assign(request.colliders.size(), {});
    m_contactWork = 0;
    if (touchesNothing(loads)) {
        m_scheme->steps(m_system, {m_duration, &loads, {}}, request.count, motion, m_solvers);
    } else {
        for (const Piece& piece : piecesOf(motion, request))
            advance(motion, piece);
    }
    m_lastLoads = loads;
}

std::vector<Stepper::Piece> Stepper::piecesOf(const Motion& motion, const Request& request) const {
    const Loads& loads = request.loads;
    const double duration = request.duration;
    const std::vector<PrescribedNode> prescribed = movable(loads.prescribed, m_system.fixed);
    if (request.colliders.empty() || m_surface.empty()) return {{{duration, &loads, prescribed}, true, {}}};
    Vectors velocities = motion.velocities;
    leadPrescribedNodes({duration, &loads, prescribed}, motion.positions, velocities);
    const int parts = contactParts(m_surface, motion.positions, velocities, request.colliders, duration);
    return cut({{duration, &loads, prescribed}, true, request.colliders}, parts, motion.positions);
}

std::vector<Stepper::Piece> Stepper::cut(const Piece& whole, int parts, const Vectors& positions) {
    std::vector<Piece> pieces;
    for (int part = 1; part <= parts; ++part) {
        const double fraction = static_cast<double>(part) / parts;
        Piece piece{whole.input, whole.isWhole && parts == 1, {}};
        piece.input.duration /= parts;
        for (PrescribedNode& node : piece.input.prescribed) {
            const Eigen::Vector3d& start = positions[node.node];
            if (part < parts) node.position = start + fraction * (node.position - start);
        }
        for (const ColliderMove& move : whole.colliders)
            piece.colliders.push_back(partOf(move, static_cast<double>(part - 1) / parts, fraction));
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

void Stepper::advance(Motion& motion, const Piece& piece) {
    m_solvers.prepare(m_system, piece.input, motion.positions);
    const bool standsAlone = !piece.isWhole || (isExplicit(m_integrator) && !piece.input.prescribed.empty());
    if (jumps(piece.input, motion.positions) || standsAlone) m_scheme->restart();
    UntouchedStep untouched = untouchedStep(*m_scheme, motion, piece);
    if (touches(motion, piece, untouched.motion.positions))
        return advanceTouched(motion, piece, std::move(untouched));
    std::swap(motion, untouched.motion);
    if (standsAlone)
        m_scheme->restart();
    else
        m_scheme->remember(std::move(untouched.motion));
}

void Stepper::prepareTouchedScheme() {
    m_touchedScheme = makeStepScheme(m_system, Integrator::Euler, m_settings, m_team);
    m_longestTouchedStep = longestEulerStep(m_system, m_settings.damping, m_integrator, m_timeStep);
}

// Explicit steps of a higher order move nodes by half of their acceleration as well. Kept outside by that
// way, tissue would end each step with as much speed into the instrument, of which viscosity takes a share of
// the force: up to a third of it in their longest steps. As contact is of the first order anyhow, touched
// steps are those of symplectic Euler, whose velocities are what moves the nodes; as many as are stable where
// a step is longer than that, as rk4's can be.
void Stepper::advanceTouched(Motion& motion, const Piece& piece, UntouchedStep untouched) {
    m_scheme->restart();
    if (!isExplicit(m_integrator) || orderOf(m_integrator) == 1) {
        if (untouched.buildsOnLast) untouched = untouchedStep(*m_scheme, motion, piece);
        makeWay(motion, piece, std::move(untouched));
        return m_scheme->restart();
    }
    if (!m_touchedScheme) prepareTouchedScheme();
    const double parts = std::ceil(piece.input.duration / m_longestTouchedStep);
    for (const Piece& part : cut(piece, static_cast<int>(std::max(1.0, parts)), motion.positions)) {
        m_touchedScheme->restart();
        UntouchedStep step = untouchedStep(*m_touchedScheme, motion, part);
        if (touches(motion, part, step.motion.positions))
            makeWay(motion, part, std::move(step));
        else
            motion = std::move(step.motion);
    }
}

void Stepper::makeWay(Motion& motion, const Piece& piece, UntouchedStep untouched) {
    m_contactWork -= energy(m_system, untouched.motion).total();
    motion = madeWay(motion, piece, std::move(untouched));
    m_contactWork += energy(m_system, motion).total();
}

bool Stepper::jumps(const StepInput& input, const Vectors& positions) {
    std::vector<PrescribedWay> ways;
    for (const PrescribedNode& led : input.prescribed)
        ways.push_back({led.node, (led.position - positions[led.node]) / input.duration});
    const auto goesOn = [](const PrescribedWay& before, const PrescribedWay& now) {
        return before.node == now.node && !isJump(before.velocity, now.velocity);
    };
    const bool goOn = std::equal(m_ways.begin(), m_ways.end(), ways.begin(), ways.end(), goesOn);
    m_ways = std::move(ways);
    return !goOn;
}

UntouchedStep Stepper::untouchedStep(StepScheme& scheme, const Motion& motion, const Piece& piece) {
    UntouchedStep untouched = scheme.step(m_system, piece.input, motion, m_solvers);
    placePrescribedNodes(piece.input, untouched.motion.positions);
    return untouched;
}

std::vector<char> Stepper::immovable(const Piece& piece) const {
    std::vector<char> result = m_system.fixed;
    for (const PrescribedNode& led : piece.input.prescribed)
        result[led.node] = 1;
    return result;
}

bool Stepper::touches(const Motion& motion, const Piece& piece, const Vectors& next) {
    if (piece.colliders.empty()) return false;
    const FoundContacts found =
        findContacts(m_surface, immovable(piece), motion.positions, next, piece.colliders);
    for (const Contact& contact : found.contacts)
        m_touches[contact.collider].touched = true;
    for (std::size_t i = 0; i < m_touches.size(); ++i)
        if (found.meetsImmovable[i]) m_touches[i].metImmovable = true;
    return !found.contacts.empty();
}

// Each round solves anew from the untouched step, with the contacts of the rounds before, turned to where the
// surface came to lie, and those that were found since: nothing is pushed twice.
Motion Stepper::madeWay(const Motion& motion, const Piece& piece, UntouchedStep untouched) {
    const double h = piece.input.duration;
    StepSolver& solver = m_solvers.forImpulses(m_system, h);
    if (untouched.half.empty()) solver.matrix.multiplyUpper(untouched.motion.velocities, untouched.half);
    const std::vector<ColliderMove>& colliders = piece.colliders;
    const std::vector<char> stays = immovable(piece);
    const std::vector<std::uint32_t> led = ledByImpulses(solver.matrix, piece.input.prescribed);
    const FluidAnswers fluids = isExplicit(m_integrator)
                                    ? FluidAnswers()
                                    : fluidAnswersOf(solver, piece.input.prescribed,
                                                     globalTermsOf(m_system, motion.positions, h * h));
    const Motion& free = untouched.motion;
    Motion next = free;
    std::vector<Contact> contacts;
    Eigen::VectorXd impulses, needed;
    for (int round = 0; round < mostContactRounds; ++round) {
        const auto found =
            findContacts(m_surface, stays, motion.positions, next.positions, colliders).contacts;
        if (round > 0 && areClear(found, colliders, contactTolerance)) break;
        mergeContacts(contacts, found, mostContacts);
        needed.resize(static_cast<Eigen::Index>(contacts.size()));
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            turnOutward(contacts[i], motion.positions, next.positions, colliders[contacts[i].collider]);
            needed[static_cast<Eigen::Index>(i)] = depth(contacts[i], free.positions) / h;
        }
        impulses.conservativeResizeLike(Eigen::VectorXd::Zero(needed.size()));
        Vectors half = untouched.half;
        const double tolerance = impulseToleranceOf(contacts, colliders) / h;
        pushContacts({contacts, needed, led, stays, tolerance, fluids}, solver.impulses, impulses, half);
        solver.matrix.solveUpper(std::move(half), next.velocities);
        for (std::size_t i = 0; i < next.positions.size(); ++i)
            if (!stays[i])
                next.positions[i] = free.positions[i] + h * (next.velocities[i] - free.velocities[i]);
    }
    const Vectors solved = next.positions;
    const std::vector<NodePush> pushes =
        projectOut(m_surface, stays, motion.positions, colliders, next.positions);
    tellImpulses({m_system,
                  m_integrator,
                  m_settings.damping,
                  h,
                  motion.positions,
                  free.velocities,
                  next.velocities,
                  {contacts, needed, led, stays, 0, fluids},
                  impulses,
                  pushes},
                 solver, m_touches);
    for (std::size_t i = 0; i < solved.size(); ++i)
        next.velocities[i] += (next.positions[i] - solved[i]) / h;
    return next;
}

} // namespace esm

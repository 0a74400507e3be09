#include "core/dynamics/statics/pressed_tissue.h"

#include "core/dynamics/bursting.h"
#include "core/dynamics/statics/balance.h"
#include "core/dynamics/statics/line_search.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double closeness = 1e-5;  ///< in radii, of triangles that were not known to be inside
constexpr double steady = 3e-4;     ///< of the force, from one update of the pushes to the next
constexpr double looseness = 0.01;  ///< of the balance, while the pushes still change by all
constexpr double smallMove = 1e-5;  ///< in radii
constexpr double firstTouch = 1e-3; ///< in radii
constexpr int mostRounds = 60;
constexpr int mostReaches = 12; ///< each twice as far as the one before

} // namespace

PressedTissue::PressedTissue(const SpringSystem& system, std::vector<Triangle> surface,
                             const Indenter& indenter, std::function<void()> checkpoint)
    : PressedTissue(system, {system.network->restPositions, {}}, std::move(surface), indenter,
                    std::move(checkpoint)) {}

PressedTissue::PressedTissue(const SpringSystem& system, const InflatedTissue& rest,
                             std::vector<Triangle> surface, const Indenter& indenter,
                             std::function<void()> checkpoint)
    : m_system(system), m_indenter(indenter), m_checkpoint(std::move(checkpoint)), m_potential(system),
      m_contacts(std::move(surface), system.fixed, indenter.radius), m_motion{rest.positions,
                                                                              Vectors(system.mass.size(),
                                                                                      Vector3d::Zero())},
      m_perDepth(system.mass.size(), Vector3d::Zero()), m_rowPlaces(restPlacesOfRows(system)) {
    m_potential.setPressures(rest.pressures);
}

double PressedTissue::force() const {
    return m_contacts.force(centre(m_depth), m_motion.positions).dot(m_indenter.inwards);
}

void PressedTissue::settle(const Drive& wanted) {
    const Vectors before = m_motion.positions;
    const double depth = m_depth;
    setLapse({});
    drive(wanted);
    expect(m_perDepth, m_depth - depth);
    balance();
    for (std::size_t i = 0; m_depth != depth && i < before.size(); ++i)
        m_perDepth[i] = (m_motion.positions[i] - before[i]) / (m_depth - depth);
    std::fill(m_motion.velocities.begin(), m_motion.velocities.end(), Vector3d::Zero());
}

void PressedTissue::step(const Drive& wanted, double duration) {
    const Vectors before = m_motion.positions;
    setLapse(TimeLapse{duration, m_motion});
    drive(wanted);
    expect(m_motion.velocities, duration);
    balance();
    for (std::size_t i = 0; i < before.size(); ++i)
        m_motion.velocities[i] = (m_motion.positions[i] - before[i]) / duration;
}

void PressedTissue::setLapse(std::optional<TimeLapse> lapse) {
    m_potential.setLapse(std::move(lapse));
    std::vector<double> stiffness = m_potential.nodeStiffness();
    m_stiffest = *std::max_element(stiffness.begin(), stiffness.end());
    m_contacts.setStiffness(std::move(stiffness));
}

void PressedTissue::drive(const Drive& wanted) {
    m_pushed.reset();
    if (const auto* const given = std::get_if<AtDepth>(&wanted))
        m_depth = given->depth;
    else
        m_pushed = std::get<UnderForce>(wanted).force;
    m_contacts.find(centre(m_depth), m_motion.positions, closeness * m_indenter.radius);
}

// A finger that touches nothing has no depth at which a force on it is balanced, and tissue may have moved on
// before it since: the search goes on where it touches.
void PressedTissue::touch() {
    double way = firstTouch * m_indenter.radius;
    for (int i = 0; i < mostReaches && m_contacts.pushes(centre(m_depth), m_motion.positions) <= 0; ++i) {
        m_depth += way;
        m_contacts.find(centre(m_depth), m_motion.positions, closeness * m_indenter.radius);
        way *= 2;
    }
    if (m_contacts.pushes(centre(m_depth), m_motion.positions) <= 0)
        throw InvalidModel("the tissue has slipped away from under the finger: choose another place, or a "
                           "smaller force");
}

/// Begins the search for balance where tissue should come to if it goes on as before, unless that is worse.
void PressedTissue::expect(const Vectors& change, double factor) {
    Vectors expected = m_motion.positions;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!m_system.fixed[i]) expected[i] += factor * change[i];
    if (potential(m_depth, expected) < potential(m_depth, m_motion.positions))
        m_motion.positions = std::move(expected);
}

double PressedTissue::potential(double depth, const Vectors& positions) const {
    return m_potential.value(positions) + m_contacts.energy(centre(depth), positions) -
           m_pushed.value_or(0) * depth;
}

// Tissue comes to rest where its energy is least of all places that leave the sphere free. Two loops find it.
// The inner one goes downhill by Newton's method, while triangles that are inside the sphere are pushed out
// as hard as they are inside. The outer one raises the pushes by what is still inside, and looks for
// triangles that the tissue brought into the sphere meanwhile. It ends where neither changes anything.
//
// A simulation with an instrument comes to the same force, of a block within a thousandth, but has to be
// waited for: a tissue takes seconds to come to rest beneath a finger, and longer the finer and softer it is.
void PressedTissue::balance() {
    double changed = 1;
    for (int round = 0; round < mostRounds; ++round) {
        const double before = m_depth;
        const double loose = std::clamp(looseness * changed, balanced, looseness);
        minimise(loose);
        changed = besidePushes(m_contacts.update(centre(m_depth), m_motion.positions));
        if (m_pushed) // whose force is there from the first round on
            changed = std::max(changed, std::abs(m_depth - before) /
                                            std::max(std::abs(m_depth), firstTouch * m_indenter.radius));
        const bool isNew =
            m_contacts.find(centre(m_depth), m_motion.positions, closeness * m_indenter.radius);
        if (changed <= steady && !isNew && loose <= looseness * steady) return;
    }
    findsNoBalance();
}

void PressedTissue::findsNoBalance() const {
    const bool bendsFreely = m_system.hinges.empty() && !m_system.network->lattice;
    throw InvalidModel("the tissue beneath the finger finds no balance at a depth of " +
                       roundedText(1000 * m_depth, 3) + " mm: press less deep or at another place" +
                       (bendsFreely ? ", or let the surface resist bending, without which it folds in many "
                                      "ways of nearly the same energy"
                                    : ""));
}

/// Of what a force is, relative to the pushes. Where tissue folds away from the finger, or is a net that
/// shears freely, there are none to be relative to: then to what moves a node by next to nothing.
double PressedTissue::besidePushes(double force) const {
    return force / std::max({m_contacts.pushes(centre(m_depth), m_motion.positions), m_pushed.value_or(0),
                             smallMove * m_indenter.radius * m_stiffest});
}

/// What forces leave over.
double PressedTissue::imbalance(const Vectors& forces) const {
    double largest = 0;
    for (const Vector3d& force : forces)
        largest = std::max(largest, force.norm());
    const double left = besidePushes(largest);
    return m_pushed ? std::max(left, std::abs(*m_pushed - force()) / *m_pushed) : left;
}

void PressedTissue::minimise(double tolerance) {
    Vectors forces;
    const auto left = [&] {
        if (m_checkpoint) m_checkpoint();
        if (const std::string burst = burstOf(m_system, m_motion.positions); !burst.empty())
            throw InvalidModel(burst);
        if (m_pushed) touch();
        m_potential.forces(m_motion.positions, forces);
        m_contacts.addForces(centre(m_depth), m_motion.positions, forces);
        return imbalance(forces);
    };
    if (!findRest(tolerance, left, [&] { return go(newtonWay(forces)); })) findsNoBalance();
}

// Pressed springs push their ends aside, so that the potential may bend downwards, where tissue is about to
// fold; and nothing resists a flat sheet's motion across, or a net's that shears freely. Then all nodes are
// tied to where they are by as little as makes the matrix positive. Half of that matrix being left out
// instead, the method would creep along a fold, whose way down is what is left out.
NewtonWay PressedTissue::newtonWay(const Vectors& forces) {
    if (auto way = m_tie.find(m_stiffest, [&](double tie) { return newtonWay(forces, tie); })) return *way;
    throw InvalidModel("the tissue beneath the finger cannot be balanced, since next to nothing holds parts "
                       "of it: give it tethers or fixed nodes");
}

std::optional<NewtonWay> PressedTissue::newtonWay(const Vectors& forces, double tie) {
    BlockEntries entries(m_system.fixed);
    m_potential.addStiffness(m_motion.positions, entries);
    m_contacts.addStiffness(centre(m_depth), m_motion.positions, entries);
    entries.addToDiagonal(tie);
    const std::optional<BlockFactor> factor = m_factoriser.factorise(entries.matrix(), m_rowPlaces);
    if (!factor) return {};
    const PushAlong push = m_contacts.along(m_indenter.inwards, centre(m_depth), m_motion.positions);
    const GlobalTerms fluids = globalTermsOf(m_system, m_motion.positions, 1);
    return esm::newtonWay({*factor, entries, fluids}, {forces, push, m_pushed});
}

/// J, by which the potential changes along a way from a place on it.
double PressedTissue::slopeAlong(const NewtonWay& way, double depth, const Vectors& positions) const {
    Vectors forces;
    m_potential.forces(positions, forces);
    m_contacts.addForces(centre(depth), positions, forces);
    double slope = 0;
    if (m_pushed) {
        const double push = m_contacts.force(centre(depth), positions).dot(m_indenter.inwards);
        slope = (push - *m_pushed) * way.depth;
    }
    return slope - scalarProduct(forces, way.nodes);
}

/// As much of the way as lowers the potential; false where none does.
bool PressedTissue::go(const NewtonWay& way) {
    Vectors tried(way.nodes.size());
    const auto put = [&](double part) {
        for (std::size_t i = 0; i < tried.size(); ++i)
            tried[i] = m_motion.positions[i] + part * way.nodes[i];
        return m_depth + part * way.depth;
    };
    const auto at = [&](double part) {
        const double depth = put(part);
        return OnWay{potential(depth, tried), slopeAlong(way, depth, tried)};
    };
    const std::optional<double> part = lowerPart({potential(m_depth, m_motion.positions), way.slope}, at);
    if (!part) return false;
    m_depth = put(*part);
    m_motion.positions = std::move(tried);
    return true;
}

} // namespace esm

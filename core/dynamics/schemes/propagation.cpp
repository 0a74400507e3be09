#include "core/dynamics/schemes/propagation.h"

#include "core/dynamics/hinge_force.h"
#include "core/dynamics/schemes/moving_fluids.h"
#include "core/dynamics/schemes/schemes.h"
#include "core/dynamics/spring_force.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Eigen::Vector3d;

constexpr double settled = 1e-8; ///< change of a force, of the largest there was
constexpr int mostPasses = 2000, passesUnasked = 16;
/// Of a place, some 50 roundings; what springs make of it cannot settle.
constexpr double roundingMargin = 1e-14;

// Always stable; but the more a node's springs outweigh its mass, the more passes its forces take to settle.
// Steps are kept to h·D + h²·K < 100·M for each motion; the root of that quadratic is written so that nothing
// cancels.
std::optional<double> largestPropagationStep(TissueSpectrum& tissue, double cap) {
    constexpr double most = 100;
    const double d = tissue.largestDamping();
    return std::min(cap, 2 * most / (d + std::sqrt(d * d + 4 * most * tissue.largestStiffness())));
}

} // namespace

const Scheme propagationScheme{.largestStable = largestPropagationStep,
                               .ownDamping = dampsAsImplicitEuler,
                               .factors = implicitEulerFactors};

PropagationScheme::PropagationScheme(const SpringSystem& system, Damping damping,
                                     std::function<bool()> isWanted)
    : m_damping(damping), m_isWanted(std::move(isWanted)), m_ties(system) {}

// Breadth first; then the parts that hang on nothing of it.
std::vector<std::uint32_t> PropagationScheme::outwardsFrom(std::uint32_t node) const {
    const auto count = static_cast<std::uint32_t>(m_ties.nodeCount());
    std::vector<std::uint32_t> order;
    std::vector<char> seen(count, 0);
    order.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        // The wanted node, and then all others in their order.
        const std::uint32_t others = i <= node ? i - 1 : i;
        const std::uint32_t seed = i == 0 ? node : others;
        if (std::exchange(seen[seed], 1)) continue;
        std::size_t reached = order.size();
        for (order.push_back(seed); reached < order.size(); ++reached)
            for (const auto& neighbour : m_ties.springsOf(order[reached]))
                if (!std::exchange(seen[neighbour.node], 1)) order.push_back(neighbour.node);
    }
    return order;
}

Vector3d PropagationScheme::forceOn(std::uint32_t node, const SpringSystem& system,
                                    const Motion& motion) const {
    Vector3d force = Vector3d::Zero();
    for (const auto& [other, number] : m_ties.springsOf(node)) {
        const SpringSystem::Element& spring = system.springs[number];
        const Vector3d between = motion.positions[node] - motion.positions[other];
        force += elasticForce(spring, between) +
                 dampingForce(spring, m_damping, between, motion.velocities[node] - motion.velocities[other]);
    }
    for (const auto& [number, place] : m_ties.hingesOf(node)) {
        const auto& hinge = system.hinges[number];
        force += elasticForces(hinge, ofNodes(hinge, motion.positions))[place] +
                 dampingForces(hinge, ofNodes(hinge, motion.velocities))[place];
    }
    const Tether& tether = m_ties.tetherOf(node);
    return force - tether.springConstant * (motion.positions[node] - system.network->restPositions[node]) -
           tether.viscosity * motion.velocities[node];
}

/// The first phase of one step: passes over the nodes until their forces settle. That is so when no force
/// changed by more than 10⁻⁸ of the largest force there ever was, not of its own: forces that balance are
/// next to nothing, and what rounding leaves of them never settles.
class PropagationScheme::LocalPropagation {
public:
    LocalPropagation(const PropagationScheme& scheme, const SpringSystem& system, const StepInput& input,
                     const Motion& before, Motion& after)
        : m_scheme(scheme), m_system(system), m_step(input.duration), m_before(before), m_after(after),
          m_given(system.fixed), m_external(before.positions.size(), Vector3d::Zero()), m_forces(m_external),
          m_fluids(system, *input.loads, before.positions) {
        addExternalForces(system, *input.loads, m_external);
        m_after = before;
        leadPrescribedNodes(input, before.positions, m_after.velocities);
        for (const PrescribedNode& led : input.prescribed) {
            m_given[led.node] = 1;
            m_after.positions[led.node] = led.position;
        }
        m_fluids = MovingFluids(system, *input.loads, m_after.positions);
        for (std::uint32_t node = 0; node < m_forces.size(); ++node) {
            m_resistance.push_back(scheme.diagonalOf(node, system, {1, m_step, m_step * m_step}));
            const MovingFluids::Push push = m_fluids.on(node);
            m_forces[node] = scheme.forceOn(node, system, before) + m_external[node] + push.force;
            if (!m_given[node]) note(node, m_forces[node].norm(), m_largestForce);
            m_rounding = std::max(
                m_rounding, roundingMargin * (scheme.diagonalOf(node, system, {0, 0, 1}) + push.stiffness) *
                                before.positions[node].norm());
        }
    }

    /// False when the forces have settled.
    bool pass() {
        const std::vector<std::uint32_t> order = m_scheme.outwardsFrom(m_start);
        double largestChange = 0;
        for (const std::uint32_t node : order)
            if (!m_given[node]) note(node, settle(node), largestChange);
        return largestChange > settled * m_largestForce + m_rounding;
    }

private:
    /// The next pass starts at the node with the largest value.
    void note(std::uint32_t node, double value, double& largest) {
        if (!(value > largest)) return;
        largest = value;
        m_start = node;
    }

    /// Gives a node the velocity its springs ask of it; by how much its force changed or is not met yet, N.
    ///
    /// Over all nodes this is Gauss and Seidel's method for the step of implicit Euler, with forces as they
    /// really are: each node sees at once what was settled before it. Its resistance is at least what its
    /// springs' forces can change by, whichever way it goes, so that it never goes beyond the place where its
    /// own forces balance. With its mass alone stiff tissue would be thrown from side to side and never
    /// settle.
    double settle(std::uint32_t node) {
        const MovingFluids::Push push = m_fluids.on(node);
        const Vector3d force = m_scheme.forceOn(node, m_system, m_after) + m_external[node] + push.force;
        const Vector3d missing =
            m_system.mass[node] * (m_before.velocities[node] - m_after.velocities[node]) + m_step * force;
        m_after.velocities[node] += missing / (m_resistance[node] + m_step * m_step * push.stiffness);
        m_after.positions[node] = m_before.positions[node] + m_step * m_after.velocities[node];
        m_fluids.move(node, m_after.positions[node]);
        m_largestForce = std::max(m_largestForce, force.norm());
        return std::max((force - std::exchange(m_forces[node], force)).norm(), missing.norm() / m_step);
    }

    const PropagationScheme& m_scheme;
    const SpringSystem& m_system;
    double m_step; ///< s
    const Motion& m_before;
    Motion& m_after;
    std::vector<char> m_given;
    Vectors m_external, m_forces; ///< N, from outside; of the last pass
    MovingFluids m_fluids;
    std::vector<double> m_resistance; ///< kg
    double m_largestForce = 0;        ///< N, ever met
    double m_rounding = 0;            ///< N
    std::uint32_t m_start = 0;
};

double PropagationScheme::diagonalOf(std::uint32_t node, const SpringSystem& system,
                                     const MatrixFactors& factors) const {
    double diagonal = factors.mass * system.mass[node];
    for (const auto& neighbour : m_ties.springsOf(node)) {
        const auto& spring = system.springs[neighbour.spring];
        diagonal += factors.damping * spring.viscosity + factors.stiffness * largestSpringConstant(spring);
    }
    for (const auto& [number, place] : m_ties.hingesOf(node)) {
        const auto& hinge = system.hinges[number];
        diagonal +=
            factors.damping * hinge.viscosity * std::pow(hinge.weights[place], 2) +
            factors.stiffness * stiffnessOfNode(hinge, place, ofNodes(hinge, system.network->restPositions));
    }
    const Tether& tether = m_ties.tetherOf(node);
    return diagonal + factors.damping * tether.viscosity + factors.stiffness * tether.springConstant;
}

UntouchedStep PropagationScheme::step(const SpringSystem& system, const StepInput& input,
                                      const Motion& before, StepperSolvers& /*solvers*/) {
    UntouchedStep step;
    LocalPropagation propagation(*this, system, input, before, step.motion);
    for (int pass = 1; pass <= mostPasses; ++pass) {
        if (!propagation.pass()) return step;
        if (pass % passesUnasked == 0 && m_isWanted && !m_isWanted()) throw Cancelled();
    }
    throw InvalidModel("the propagation does not settle within a step: shorten the step, or choose split");
}

} // namespace esm

#include "core/dynamics/schemes/told_impulses.h"

#include "core/dynamics/hinge_force.h"
#include "core/dynamics/spring_force.h"

namespace esm {

namespace {

using Eigen::Vector3d;

/// Velocities that one instrument gave by its contacts and by what it moved afterwards, m/s.
Vectors givenBy(std::size_t instrument, const MadeWay& way, StepSolver& solver, bool byContacts) {
    Vectors given(way.before.size(), Vector3d::Zero());
    Eigen::VectorXd own = way.impulses;
    for (Eigen::Index i = 0; i < own.size(); ++i)
        if (way.problem.contacts[static_cast<std::size_t>(i)].collider != instrument) own[i] = 0;
    if (byContacts && own == way.impulses) {
        for (std::size_t i = 0; i < given.size(); ++i)
            given[i] = way.solved[i] - way.free[i];
    } else if (byContacts) {
        Vectors half;
        solver.matrix.multiplyUpper(given, half); // nothing yet
        layImpulses(way.problem, solver.impulses, own, half);
        solver.matrix.solveUpper(std::move(half), given);
    }
    for (const NodePush& push : way.pushes)
        if (push.collider == instrument) given[push.node] += push.way / way.duration;
    return given;
}

/// N·s, that a spring takes up through its end on what does not move, as the other end's velocity changes.
Vector3d takenUp(const SpringSystem::Element& spring, const MadeWay& way, const MatrixFactors& factors,
                 const Vector3d& change) {
    const SpringTangent tangent =
        factors.stiffness == 0 && way.damping == Damping::Isotropic
            ? SpringTangent{}
            : tangentOf(spring, way.before[spring.first] - way.before[spring.second]);
    return resistance(spring, tangent, way.damping, factors, change);
}

/// The same of a hinge, of which some nodes do not move.
Vector3d takenUp(const SpringSystem::HingeElement& hinge, const MadeWay& way, const MatrixFactors& factors,
                 const Vectors& change) {
    HingeVectors moved = ofNodes(hinge, change);
    const auto stays = [&](std::size_t i) { return way.problem.immovable[hinge.nodes[i]] != 0; };
    for (std::size_t i = 0; i < 4; ++i)
        if (stays(i)) moved[i].setZero();
    const HingeVectors stiff =
        stiffnessTimes(hinge, bentHinge(hinge, ofNodes(hinge, way.before)), true, moved);
    const HingeVectors viscous = dampingForces(hinge, moved);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i)
        if (!stays(i)) sum += factors.stiffness * stiff[i] - factors.damping * viscous[i];
    return sum;
}

/// A wall that moves as a whole gives a fluid's pressure nothing to push against: what does not move has the
/// rest.
Vector3d movableSum(const Vectors& gradient, const std::vector<char>& immovable) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < gradient.size(); ++i)
        if (!immovable[i]) sum += gradient[i];
    return sum;
}

/// N·s, that nodes which move must be given in all for a change of their velocities: their own momentum and
/// what their ties take up within the step. Springs and hinges between them keep momentum.
Vector3d impulseFor(const Vectors& change, const MadeWay& way) {
    const SpringSystem& system = way.system;
    const std::vector<char>& immovable = way.problem.immovable;
    const MatrixFactors factors = stepFactors(way.integrator, way.duration, false);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < change.size(); ++i)
        if (!immovable[i]) sum += system.mass[i] * change[i];
    if (factors.damping == 0 && factors.stiffness == 0) return sum;
    for (const SpringSystem::Element& spring : system.springs)
        if (immovable[spring.first] != immovable[spring.second])
            sum +=
                takenUp(spring, way, factors, change[immovable[spring.first] ? spring.second : spring.first]);
    for (const auto& hinge : system.hinges)
        sum += takenUp(hinge, way, factors, change);
    for (const Tether& tether : system.tethers)
        if (!immovable[tether.node])
            sum += (factors.damping * tether.viscosity + factors.stiffness * tether.springConstant) *
                   change[tether.node];
    for (const GlobalTerm& term : way.problem.fluids.correction.terms())
        sum += term.factor * scalarProduct(term.gradient, change) * movableSum(term.gradient, immovable);
    return sum;
}

} // namespace

// By Newton's third law an instrument's force is what the tissue lacks to keep its balance: the momentum that
// the instrument gave it, and what that did to the ties that hold it, within the step. Explicit steps and
// `split` take that from the contacts' impulses themselves. Steps that solve for forces as they really are do
// not: their contacts answer by a constant matrix, in which springs resist sideways as much as along, and
// impulses grow by what that resistance takes up. There the velocities that an instrument gave are held
// against the matrix with which the step was solved; on a net pushed across, the bare impulses are twice the
// force. What is moved out after the solution counts alike.
void tellImpulses(const MadeWay& way, StepSolver& solver, std::vector<InstrumentTouch>& touches) {
    const bool bySolution = !isExplicit(way.integrator) && !hasConstantMatrix(way.integrator);
    const auto& contacts = way.problem.contacts;
    for (std::size_t i = 0; i < contacts.size() && !bySolution; ++i)
        touches[contacts[i].collider].impulse -=
            way.impulses[static_cast<Eigen::Index>(i)] * contacts[i].plane.normal;
    if (!bySolution && way.pushes.empty()) return;
    for (std::size_t instrument = 0; instrument < touches.size(); ++instrument)
        touches[instrument].impulse -= impulseFor(givenBy(instrument, way, solver, bySolution), way);
}

} // namespace esm

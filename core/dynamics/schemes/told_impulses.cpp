#include "core/dynamics/schemes/told_impulses.h"

#include "core/dynamics/schemes/implicit_system.h"

namespace esm {

namespace {

using Eigen::Vector3d;

/// Whether the step's own solution takes springs as stiff as they are, and the contacts' alone as stiff as
/// their constants in every direction.
bool followsTangents(Integrator integrator) {
    return integrator == Integrator::Implicit || integrator == Integrator::Bdf2;
}

/// Velocities that one instrument gave by its contacts and by what it moved afterwards, m/s.
Vectors givenBy(std::size_t instrument, const MadeWay& way, StepSolver& solver, bool byContacts) {
    Vectors given(way.before.size(), Vector3d::Zero());
    if (byContacts) {
        Eigen::VectorXd own = way.impulses;
        for (Eigen::Index i = 0; i < own.size(); ++i)
            if (way.problem.contacts[static_cast<std::size_t>(i)].collider != instrument) own[i] = 0;
        Vectors half;
        solver.matrix.multiplyUpper(given, half); // nothing yet
        layImpulses(way.problem, solver.impulses, own, half);
        solver.matrix.solveUpper(std::move(half), given);
    }
    for (const NodePush& push : way.pushes)
        if (push.collider == instrument) given[push.node] += push.way / way.duration;
    return given;
}

/// N·s, that nodes which move must be given in all for a change of their velocities.
Vector3d impulseFor(const Vectors& change, const TangentMatrix& matrix, const std::vector<char>& immovable) {
    Vectors momentum;
    matrix.multiply(change, momentum);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < momentum.size(); ++i)
        if (!immovable[i]) sum += momentum[i];
    return sum;
}

} // namespace

// By Newton's third law an instrument's force is what the tissue lacks to keep its balance: the momentum that
// the instrument gave it, and what that did to the ties that hold it, within the step. Explicit steps and
// `split` take that from the contacts' impulses themselves. Implicit steps do not: their contacts answer by a
// constant matrix, in which springs resist sideways as much as along, and impulses grow by what that
// resistance takes up. There the velocities that an instrument gave are held against the matrix with which
// the step was solved; on a net pushed across, the bare impulses are twice the force. What is moved out after
// the solution counts alike.
void tellImpulses(const MadeWay& way, StepSolver& solver, std::vector<InstrumentTouch>& touches) {
    const bool bySolution = followsTangents(way.integrator);
    const auto& contacts = way.problem.contacts;
    for (std::size_t i = 0; i < contacts.size() && !bySolution; ++i)
        touches[contacts[i].collider].impulse -=
            way.impulses[static_cast<Eigen::Index>(i)] * contacts[i].plane.normal;
    if (!bySolution && way.pushes.empty()) return;
    const TangentMatrix matrix(way.system, way.damping, stepFactors(way.integrator, way.duration, false),
                               way.before);
    for (std::size_t instrument = 0; instrument < touches.size(); ++instrument)
        touches[instrument].impulse -=
            impulseFor(givenBy(instrument, way, solver, bySolution), matrix, way.problem.immovable);
}

} // namespace esm

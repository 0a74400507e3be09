#include "core/dynamics/schemes/fluid_answers.h"

#include <utility>

namespace esm {

namespace {

/// With the matrix alone. Led nodes that are in it come between its two halves: there an impulse on a single
/// node is one sparse column, and the impulses that give all of them their velocities are a small dense
/// system.
void solveAlone(StepSolver& solver, const std::vector<std::uint32_t>& led, const Vectors& momentum,
                Vectors& velocities, Vectors& half) {
    solver.matrix.solveLower(momentum, velocities, half);
    if (!led.empty()) solver.impulses.lead(led, velocities, half);
    solver.matrix.solveUpper(half, velocities);
}

} // namespace

// The terms' gradients turn with the tissue and are new in every step, while the matrix stays factorised:
// each costs a further solve with it. Gradients kept from rest would save that, but a term along another
// gradient than that of the force resists what is no change of volume, and leaves changes of volume
// unresisted: tissue that has turned would run away.
FluidAnswers fluidAnswersOf(StepSolver& solver, const std::vector<PrescribedNode>& prescribed,
                            GlobalTerms terms) {
    FluidAnswers answers;
    if (terms.empty()) return answers;
    const std::vector<std::uint32_t> led = ledByImpulses(solver.matrix, prescribed);
    std::vector<Vectors> responses;
    for (const GlobalTerm& term : terms) {
        responses.emplace_back(term.gradient.size(), Eigen::Vector3d::Zero());
        solveAlone(solver, led, term.gradient, responses.back(), answers.halfResponses.emplace_back());
    }
    answers.correction = GlobalCorrection(std::move(terms), std::move(responses));
    return answers;
}

void solveStep(StepSolver& solver, const std::vector<PrescribedNode>& prescribed, GlobalTerms terms,
               const Vectors& momentum, Vectors& velocities, Vectors& half) {
    solveAlone(solver, ledByImpulses(solver.matrix, prescribed), momentum, velocities, half);
    const FluidAnswers fluids = fluidAnswersOf(solver, prescribed, std::move(terms));
    if (fluids.isEmpty()) return;
    fluids.takeOff(fluids.correction.excess(velocities), half);
    fluids.correction.correct(velocities);
}

} // namespace esm

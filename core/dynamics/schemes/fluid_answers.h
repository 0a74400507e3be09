#pragma once

#include "core/dynamics/contact/contact_impulses.h"
#include "core/dynamics/schemes/step_solver.h"

namespace esm {

/// How fluids answer in a step with this matrix and the terms beside it; led nodes are where they are led.
FluidAnswers fluidAnswersOf(StepSolver& solver, const std::vector<PrescribedNode>& prescribed,
                            GlobalTerms terms);

/// Solves for a step's velocities with its constant matrix and the terms beside it. Given and led nodes' are
/// given in `velocities`; `half` is the half-solved step, for impulses on single nodes.
void solveStep(StepSolver& solver, const std::vector<PrescribedNode>& prescribed, GlobalTerms terms,
               const Vectors& momentum, Vectors& velocities, Vectors& half);

} // namespace esm

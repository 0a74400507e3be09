#pragma once

#include "core/dynamics/contact/node_impulses.h"
#include "core/dynamics/motion.h"
#include "core/model/integrators.h"

namespace esm {

/// The factorised matrix of a step, and how impulses on single nodes act through it.
struct StepSolver {
    StepMatrix matrix;
    NodeImpulses impulses;

    explicit StepSolver(StepMatrix&& factorised) : matrix(std::move(factorised)), impulses(matrix) {}
    StepSolver(const StepSolver&) = delete;
    StepSolver& operator=(const StepSolver&) = delete;
};

/// The matrix of a step of so many seconds, as Scheme::factors says.
/// @param builds on the step before; else the matrix is that of the integrator it starts as
MatrixFactors stepFactors(Integrator integrator, double duration, bool builds);

/// A step before anything touched it.
struct UntouchedStep {
    Motion motion;
    Vectors half;              ///< half-solved velocities, N·s/√kg; empty where none were needed
    bool buildsOnLast = false; ///< it was solved with the matrix of such steps
};

/// Those of the prescribed nodes that the matrix does not take for given.
std::vector<std::uint32_t> ledByImpulses(const StepMatrix& matrix,
                                         const std::vector<PrescribedNode>& prescribed);

} // namespace esm

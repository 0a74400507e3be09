#pragma once

#include "core/dynamics/schemes/step_solvers.h"

namespace esm {

/// The factorised matrices that a Stepper solves with, in two sets: one gives the fixed nodes' velocities and
/// solves for all others, the other gives those of the led nodes as well, while many are led.
class StepperSolvers {
public:
    /// @param free of the fixed nodes
    StepperSolvers(const SpringSystem& system, Integrator integrator, StepSolvers free);

    /// Before the first step: takes over what the factorisers of the former stepper know, and their time.
    void takeOver(const StepperSolvers& former);

    /// Before each step: which nodes are led in it, and which springs are strained where it begins. What
    /// branch() gave before may be gone.
    void prepare(const SpringSystem& system, const StepInput& input, const Vectors& positions);

    /// Whether the matrix of such steps depends on what is strained.
    bool hasBranches(double duration) const;

    /// Of a step that builds on the one before, or on none: with every spring as stiff as it may become.
    /// @throws InvalidModel, here and below, where the matrix cannot be factorised
    StepSolver& linear(const SpringSystem& system, double duration, bool builds);
    /// Each spring as stiff as on its branch; what is never strained far is as if its law were linear.
    StepSolver& branch(const SpringSystem& system, double duration);
    /// What impulses of contact act through.
    StepSolver& forImpulses(const SpringSystem& system, double duration);

    /// Takes in what is strained at these places: whether branch() has another matrix now, and what it gave
    /// before is gone.
    bool strain(const SpringSystem& system, const Vectors& positions);
    /// Takes all springs for strained; what branch() gave before is gone.
    void strainAll();

    /// Knows the network's order of elimination.
    const std::shared_ptr<MatrixFactoriser>& factoriser() const { return m_free.factoriser(); }
    /// s, wall time that all of them and their former ones have spent factorising.
    double factorisationSeconds() const;

private:
    StepSolvers& solvers() { return m_leadsMany ? m_led : m_free; }
    void prescribe(const std::vector<PrescribedNode>& led, const std::vector<char>& fixed);
    void forgetBranches();

    Integrator m_integrator;
    bool m_leadsMany = false;
    StepSolvers m_free; ///< of the fixed nodes
    StepSolvers m_led;  ///< of these and the led ones, as they were when many were led last
    StrainedSprings m_strained;
    double m_formerSeconds = 0; ///< that factorisers took which are no longer used
};

} // namespace esm

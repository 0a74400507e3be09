#pragma once

#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/strained_springs.h"

#include <map>
#include <memory>
#include <utility>

namespace esm {

/// Of steps: the same for durations that differ by rounding alone.
long lengthOf(double duration);

/// The factorised matrices of one tissue's steps, with some nodes given. Each is made when it is first
/// asked for, and kept.
class StepSolvers {
public:
    /// @param given per node
    /// @param factoriser may know the order of elimination from tissue with the same network
    StepSolvers(std::vector<char> given, std::shared_ptr<MatrixFactoriser> factoriser);

    const std::vector<char>& given() const { return m_given; }
    const std::shared_ptr<MatrixFactoriser>& factoriser() const { return m_factoriser; }
    /// For what is asked for from now on.
    void setFactoriser(std::shared_ptr<MatrixFactoriser> factoriser) { m_factoriser = std::move(factoriser); }

    /// Of a step of so many seconds, with every spring as stiff as it may become.
    /// @param builds on the step before: see stepFactors()
    /// @throws InvalidModel where the matrix cannot be factorised
    StepSolver& linear(const SpringSystem& system, Integrator integrator, double duration, bool builds);

    /// Of a step that builds on none, with each spring as stiff as it is where its strain is now. The caller
    /// forgets them when that changes. @throws InvalidModel
    StepSolver& branch(const SpringSystem& system, const StrainedSprings& strained, Integrator integrator,
                       double duration);
    void forgetBranches() { m_branches.clear(); }

private:
    std::vector<char> m_given;
    std::shared_ptr<MatrixFactoriser> m_factoriser;
    std::map<std::pair<long, bool>, std::unique_ptr<StepSolver>> m_linear; ///< by length and form
    std::map<long, std::unique_ptr<StepSolver>> m_branches;                ///< by length
};

} // namespace esm

#pragma once

#include "core/dynamics/kernel/tissue_kernel.h"
#include "core/dynamics/motion.h"

#include <vector>

namespace esm {

/// The integrators that need nothing but accelerations, on the kernel, and what they carry from step to step.
template<class Real> class ExplicitScheme {
public:
    /// Precondition: isExplicit(integrator). @throws InvalidModel when there are too many nodes
    ExplicitScheme(const SpringSystem& system, Integrator integrator, const KernelOptions& options);

    /// So many steps, as if nothing touched the tissue. Led nodes move evenly, in one step. `after` may be
    /// `before`. Precondition: since the last step nothing changed the motion, or restart() was called.
    void steps(const StepInput& input, std::size_t count, const Motion& before, Motion& after);

    /// Forgets what earlier steps left behind.
    void restart();

private:
    using State = typename TissueKernel<Real>::State;
    struct Term {
        double factor; ///< s
        const State* rates;
    };

    void load(const StepInput& input, const Motion& before);
    State next(const StepInput& input);
    State rates(const StepInput& input, const State& state) const;
    static State advanced(const State& start, std::initializer_list<Term> terms);
    State euler(const StepInput& input);
    State verlet(const StepInput& input);
    State heun(const StepInput& input) const;
    State rungeKutta(const StepInput& input, const State& first) const;
    State adamsMoulton(const StepInput& input);

    TissueKernel<Real> m_kernel;
    Integrator m_integrator;
    State m_spare;              ///< before the last step; its memory serves the next one
    State m_state;              ///< after the last step; empty after a restart
    std::vector<State> m_rates; ///< of the last steps, the newest first
};

extern template class ExplicitScheme<float>;
extern template class ExplicitScheme<double>;

} // namespace esm

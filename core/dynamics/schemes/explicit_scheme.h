#pragma once

#include "core/dynamics/schemes/explicit_work.h"
#include "core/dynamics/schemes/step_scheme.h"
#include "core/model/integrators.h"

namespace esm {

/// Steps of the integrators that need nothing but accelerations. What rests is left out: the method of each
/// integrator computes active slices alone.
template<class Real> class ExplicitScheme : public StepScheme {
public:
    /// Precondition: isExplicit(integrator).
    /// @param restTolerance as in SimulationSettings
    /// @throws InvalidModel when there are too many nodes
    ExplicitScheme(const SpringSystem& system, Integrator integrator, const KernelOptions& options,
                   double restTolerance);

    /// Led nodes move evenly. Precondition: since the last step nothing changed the motion, or restart() was
    /// called.
    UntouchedStep step(const SpringSystem& system, const StepInput& input, const Motion& before,
                       StepperSolvers& solvers) override;
    void steps(const SpringSystem& system, const StepInput& input, std::size_t count, Motion& motion,
               StepperSolvers& solvers) override;
    void restart() override;
    double activeFraction() const override { return m_activeFraction; }
    /// Precondition: springs and hinges join the same nodes as before.
    std::unique_ptr<StepScheme> withParameters(const SpringSystem& system) const override;

private:
    using State = typename TissueKernel<Real>::State;

    /// `after` may be `before`.
    void run(const StepInput& input, std::size_t count, const Motion& before, Motion& after);
    void load(const StepInput& input, const Motion& before);
    void followMotion(double timeStep);
    void rest(const typename TissueKernel<Real>::SliceList& slices);

    void (*m_step)(ExplicitWork<Real>& work, const StepInput& input); ///< from `state` into `next`
    double m_restTolerance;                                           ///< m
    ExplicitWork<Real> m_work;
    std::size_t m_stepsSinceLoad = 0;
    double m_activeFraction = 1;
    bool m_isLoaded = false;
};

extern template class ExplicitScheme<float>;
extern template class ExplicitScheme<double>;

} // namespace esm

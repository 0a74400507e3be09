#pragma once

#include "core/dynamics/schemes/explicit_work.h"
#include "core/model/integrators.h"

namespace esm {

/// Steps of the integrators that need nothing but accelerations. What rests is left out: the method of each
/// integrator computes active slices alone.
template<class Real> class ExplicitScheme {
public:
    /// Precondition: isExplicit(integrator).
    /// @param restTolerance as in SimulationSettings
    /// @throws InvalidModel when there are too many nodes
    ExplicitScheme(const SpringSystem& system, Integrator integrator, const KernelOptions& options,
                   double restTolerance);

    /// The same for other parameters of the same network. Precondition: nodes and springs join as before.
    ExplicitScheme withParameters(const SpringSystem& system) const;

    /// So many steps, as if nothing touched the tissue. Led nodes move evenly, in one step. `after` may be
    /// `before`. Precondition: since the last step nothing changed the motion, or restart() was called.
    void steps(const StepInput& input, std::size_t count, const Motion& before, Motion& after);

    /// Forgets what earlier steps left behind.
    void restart();

    /// Share of the nodes that the last steps were computed for.
    double activeFraction() const { return m_activeFraction; }

private:
    using State = typename TissueKernel<Real>::State;

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

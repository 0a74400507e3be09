#pragma once

#include "core/dynamics/motion.h"
#include "core/dynamics/schemes/active_slices.h"

#include <vector>

namespace esm {

/// The integrators that need nothing but accelerations, on the kernel, and what they carry from step to step.
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
    using Record = typename State::value_type;
    struct Term {
        double factor; ///< s
        const State* rates;
    };

    void load(const StepInput& input, const Motion& before);
    /// From m_state into m_next.
    void step(const StepInput& input);
    void euler(const StepInput& input);
    void verlet(const StepInput& input);
    void heun(const StepInput& input);
    void rungeKutta(const StepInput& input, const State& first);
    void adamsMoulton(const StepInput& input);

    void computeRates(const StepInput& input, const State& state, State& rates);
    const State& stage(std::initializer_list<Term> terms);
    static void addRates(std::initializer_list<Term> terms, std::size_t row, Record& record);
    void advance(State& to, std::initializer_list<Term> terms) const;
    /// The same into m_next, keeping what rounding takes from the positions.
    void finish(std::initializer_list<Term> terms);
    void addKeeping(Real change, std::size_t row, int axis, Real& position);
    template<class Visit> void forActiveRows(const Visit& visit) const;
    void followMotion(double timeStep);
    void rest(const typename TissueKernel<Real>::SliceList& slices);

    TissueKernel<Real> m_kernel;
    Integrator m_integrator;
    double m_restTolerance; ///< m
    ActiveSlices<Real> m_active;
    std::size_t m_stepsSinceLoad = 0;
    double m_activeFraction = 1;

    // Slices at rest have the same content in all of these, and none in the rates.
    State m_state;                                        ///< after the last step
    State m_next;                                         ///< being computed; else before the last step
    State m_stage;                                        ///< on the way to the next
    typename TissueKernel<Real>::Remainders m_remainders; ///< of m_state; in float alone
    std::vector<State> m_stageRates;
    std::vector<State> m_rates;   ///< of the last steps, the newest first
    std::size_t m_ratesKnown = 0; ///< of these, since the last restart
    bool m_isLoaded = false;
};

extern template class ExplicitScheme<float>;
extern template class ExplicitScheme<double>;

} // namespace esm

#pragma once

#include "core/dynamics/motion.h"
#include "core/dynamics/schemes/active_slices.h"
#include "core/dynamics/schemes/fluid_forces.h"

#include <type_traits>
#include <vector>

namespace esm {

/// In double precision no number of steps that can be waited for adds up to anything.
template<class Real> inline constexpr bool keepsRemainders = std::is_same_v<Real, float>;

template<class Real> void addToComponents(Real (&components)[4], const Eigen::Vector3d& change) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] += static_cast<Real>(change[axis]);
}

template<class Real> void setComponents(Real (&components)[4], const Eigen::Vector3d& value) {
    for (int axis = 0; axis < 3; ++axis)
        components[axis] = static_cast<Real>(value[axis]);
}

/// What explicit integrators compute with: the kernel, the state before and after a step, and evaluations of
/// the rates y' = (v, a). Slices at rest have the same content in all states, and none in the rates.
template<class Real> struct ExplicitWork {
    using State = typename TissueKernel<Real>::State;
    using Record = typename State::value_type;
    struct Term {
        double factor; ///< s
        const State* rates;
    };

    TissueKernel<Real> kernel;
    ActiveSlices<Real> active;
    FluidForces<Real> fluids;
    State state{};                                        ///< after the last step
    State next{};                                         ///< being computed; else before the last step
    State between{};                                      ///< on the way to the next
    typename TissueKernel<Real>::Remainders remainders{}; ///< of the state; in float alone
    std::vector<State> stageRates{};                      ///< within a step
    std::vector<State> keptRates{};                       ///< of the last steps, the newest first
    std::size_t ratesKnown = 0;                           ///< of these, since the last restart

    /// Calls `visit(row, inverse mass in 1/kg, force in N)` for what acts at a state beside springs, tethers
    /// and gravity: forces on single nodes, then fluids.
    /// @param share of the step's time that has passed at the state
    template<class Visit>
    void forOuterForces(const Loads& loads, double share, const State& at, const Visit& visit) {
        for (const auto& [node, force] : loads.forces)
            if (active.contains(kernel.sliceOf(node)))
                visit(kernel.rowOf(node), double(kernel.inverseMass(node)), force);
        fluids.forEach(loads, share, at, visit);
    }

    /// @param share of the step's time that has passed at the state
    void computeRates(const StepInput& input, double share, const State& at, State& rates);
    /// state + Σ factor·rates, into `between`
    const State& stage(std::initializer_list<Term> terms);
    /// The same into any other.
    void advance(State& to, std::initializer_list<Term> terms) const;
    /// The same into `next`, keeping what rounding takes from the positions.
    void finish(std::initializer_list<Term> terms);

    /// Adds to a position, m, what it changes by and what rounding took from it before.
    void addKeeping(Real change, std::size_t row, int axis, Real& position) {
        if constexpr (!keepsRemainders<Real>) {
            position += change;
            return;
        }
        Real& remainder =
            remainders[row / esm::kernel::sliceHeight].of[axis].of[row % esm::kernel::sliceHeight];
        const Real whole = change + remainder, result = position + whole;
        remainder = whole - (result - position);
        position = result;
    }

    template<class Visit> void forActiveRows(const Visit& visit) const {
        if (active.areAll()) {
            for (std::size_t row = 0; row < state.size(); ++row)
                visit(row);
            return;
        }
        for (const std::size_t slice : active.list())
            for (std::size_t row = slice * esm::kernel::sliceHeight;
                 row < (slice + 1) * esm::kernel::sliceHeight; ++row)
                visit(row);
    }
};

extern template struct ExplicitWork<float>;
extern template struct ExplicitWork<double>;

} // namespace esm

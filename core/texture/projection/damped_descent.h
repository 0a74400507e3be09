#pragma once

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace esm {

struct DescentLimits {
    int steps;
    double leastGain;   ///< share of the cost below which a step ends the descent
    double mostDamping; ///< relative to the diagonal, from which on no step is tried
};

/// The state of least cost near one, by Levenberg and Marquardt's method. Damping scales the diagonal instead
/// of adding to it (Marquardt 1963), so that unknowns are held back alike, whatever their units.
/// @param equationsAt gives a state's `normal` matrix, the `gradient` of half the `cost`, and the cost, which
/// is infinite where the state may not be
/// @param moved gives the state after a step
template<typename State, typename EquationsAt, typename Moved>
State descended(State state, const EquationsAt& equationsAt, const Moved& moved,
                const DescentLimits& limits) {
    constexpr double firstDamping = 1e-3, leastDamping = 1e-12;
    auto here = equationsAt(state);
    double damping = firstDamping;
    for (int i = 0; i < limits.steps && damping < limits.mostDamping && std::isfinite(here.cost); ++i) {
        auto damped = here.normal;
        damped.diagonal() *= 1 + damping;
        const auto step = (-damped.ldlt().solve(here.gradient)).eval();
        const State there = moved(state, step);
        const auto next = equationsAt(there);
        if (!step.allFinite() || !(next.cost <= here.cost)) {
            damping *= 10;
            continue;
        }
        const double gained = here.cost - next.cost;
        state = there;
        here = next;
        if (gained <= limits.leastGain * here.cost) break;
        damping = std::max(damping / 10, leastDamping);
    }
    return state;
}

} // namespace esm

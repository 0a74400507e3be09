#include "core/dynamics/spectrum/oscillator.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Complex = std::complex<double>;

constexpr double roundingSlack = 1e-12; ///< a mode that keeps its size is stable

/// Where a condition that holds at `good` and not at `bad` changes.
template<class Condition> double boundary(double good, double bad, Condition holds) {
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (good + bad) / 2;
        (holds(middle) ? good : bad) = middle;
    }
    return good;
}

} // namespace

// The oscillation is the sum of two motions y' = z·y, where z² + d·z + k = 0.
double growthFactor(Growth growth, const StepOscillator& oscillator) {
    const auto& [b, a] = oscillator;
    const Complex root = std::sqrt(Complex(b * b - 4 * a));
    return std::max(growth((-b + root) / 2.0), growth((-b - root) / 2.0));
}

// Searched upwards in steps of a fifth before it is halved in: growth need not rise steadily with stiffness,
// and the first stiffness that grows is what counts, not one of several ends of stable stretches.
double stiffnessLimit(Growth growth, double stepDamping) {
    const auto holds = [&](double stiffness) {
        return growthFactor(growth, {stepDamping, stiffness}) <= 1 + roundingSlack;
    };
    constexpr double least = 1e-9, factor = 1.2;
    constexpr int steps = 130; // to 20, beyond every limit
    double good = 0;
    for (int step = 0; step < steps; ++step) {
        const double stiffness = least * std::pow(factor, step);
        if (!holds(stiffness)) return boundary(good, stiffness, holds);
        good = stiffness;
    }
    return good;
}

double decayLimit(Growth growth) {
    return boundary(0.1, 4, [&](double rate) { return growth(-rate) <= 1 + roundingSlack; });
}

} // namespace esm

#include "core/dynamics/stability/oscillator.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>

namespace esm {

namespace {

using Complex = std::complex<double>;

constexpr double roundingSlack = 1e-12; ///< a mode that keeps its size is stable

/// By which y' = z·y grows in a step of length 1.
double linearGrowth(Integrator integrator, Complex z) {
    if (integrator == Integrator::Heun) return std::abs(1.0 + z + z * z / 2.0);
    if (integrator == Integrator::Rk4)
        return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
    const Complex part = z / 24.0;
    Eigen::Matrix4cd recurrence = Eigen::Matrix4cd::Zero();
    recurrence.row(0) << 1.0 + part * (28.0 + 495.0 * part), part * (-5.0 - 531.0 * part),
        part * (1.0 + 333.0 * part), -81.0 * part * part;
    recurrence.bottomLeftCorner<3, 3>().setIdentity();
    return Eigen::ComplexEigenSolver<Eigen::Matrix4cd>(recurrence, false).eigenvalues().cwiseAbs().maxCoeff();
}

/// Where a condition that holds at `good` and not at `bad` changes.
template<class Condition> double boundary(double good, double bad, Condition holds) {
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = (good + bad) / 2;
        (holds(middle) ? good : bad) = middle;
    }
    return good;
}

} // namespace

double growthFactor(Integrator integrator, const StepOscillator& oscillator) {
    const auto& [b, a] = oscillator;
    const Complex root = std::sqrt(Complex(b * b - 4 * a));
    return std::max(linearGrowth(integrator, (-b + root) / 2.0), linearGrowth(integrator, (-b - root) / 2.0));
}

double stiffnessLimit(Integrator integrator, double stepDamping) {
    const auto holds = [&](double stiffness) {
        return growthFactor(integrator, {stepDamping, stiffness}) <= 1 + roundingSlack;
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

double decayLimit(Integrator integrator) {
    return boundary(0.1, 4,
                    [&](double rate) { return linearGrowth(integrator, -rate) <= 1 + roundingSlack; });
}

double split2Limit(double stepDamping) {
    if (stepDamping >= 8.0 / 7) return 16.0 / 3 + 4.0 / 3 * stepDamping;
    // Roots e^{iθ}, u = 1 − cos θ: stepDamping = 2u²/(1+3u), limit = stepDamping·(1/u + 5/2 + 3u/2).
    const double u = (3 * stepDamping + std::sqrt(9 * stepDamping * stepDamping + 8 * stepDamping)) / 4;
    return u > 0 ? stepDamping * (1 / u + 2.5 + 1.5 * u) : 0;
}

} // namespace esm

#pragma once

#include <cmath>
#include <complex>

/// Displacement at time t of a mass on a damped spring to a fixed point, after a constant force begins to
/// act. SI units.
inline double analyticOscillator(double mass, double stiffness, double damping, double force, double t) {
    const std::complex<double> root =
        std::sqrt(std::complex<double>(damping * damping - 4 * mass * stiffness));
    const std::complex<double> a = (-damping + root) / (2 * mass), b = (-damping - root) / (2 * mass);
    return force / stiffness * (1.0 + (b * std::exp(a * t) - a * std::exp(b * t)) / (a - b)).real();
}

#pragma once

#include <algorithm>
#include <limits>

namespace esm {

/// How a spring goes on beyond a strain: with another spring constant, its force continuous (biphasic).
struct SecondPhase {
    double strain = std::numeric_limits<double>::infinity(); ///< relative lengthening, ≥ 0; infinite: linear
    double springConstant = 0;                               ///< N/m beyond

    bool isLinear() const { return strain == std::numeric_limits<double>::infinity(); }
};

/// Tension over length, N/m, with c and c₂ the spring constants up to the strain ε and beyond, ρ the rest
/// length over the length:
///   c·(1 − ρ) + (c₂ − c)·max(0, 1 − (1 + ε)·ρ)
inline double tensionPerLength(double springConstant, const SecondPhase& secondPhase, double restRatio) {
    const double linear = springConstant * (1 - restRatio);
    if (secondPhase.isLinear()) return linear;
    return linear + (secondPhase.springConstant - springConstant) *
                        std::max(0.0, 1 - (1 + secondPhase.strain) * restRatio);
}

/// N/m, where the spring is stiffest.
inline double largestSpringConstant(double springConstant, const SecondPhase& secondPhase) {
    return secondPhase.isLinear() ? springConstant : std::max(springConstant, secondPhase.springConstant);
}

inline bool isBeyond(const SecondPhase& secondPhase, double restRatio) {
    return !secondPhase.isLinear() && (1 + secondPhase.strain) * restRatio < 1;
}

/// N/m, what the force grows by with the length.
inline double slope(double springConstant, const SecondPhase& secondPhase, double restRatio) {
    return isBeyond(secondPhase, restRatio) ? secondPhase.springConstant : springConstant;
}

/// J. With s and s₂ the lengthening from rest and from where the strain ε is reached:
///   c/2·s² + (c₂ − c)/2·max(0, s₂)²
inline double elasticEnergy(double springConstant, const SecondPhase& secondPhase, double restLength,
                            double length) {
    const double stretch = length - restLength;
    const double linear = 0.5 * springConstant * stretch * stretch;
    if (secondPhase.isLinear()) return linear;
    const double beyond = std::max(0.0, length - (1 + secondPhase.strain) * restLength);
    return linear + 0.5 * (secondPhase.springConstant - springConstant) * beyond * beyond;
}

} // namespace esm

#pragma once

#include "core/dynamics/matrix_factors.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/spectrum/oscillator.h"
#include "core/dynamics/spectrum/tissue_spectrum.h"

#include <optional>

namespace esm {

template<class Real> struct ExplicitWork;

/// How an explicit integrator takes a step, on the kernel.
struct ExplicitMethod {
    std::size_t stageRates = 0; ///< evaluations in use at once within a step; one may overwrite another
    std::size_t keptRates = 0;  ///< evaluations that outlive their step
    void (*stepInDouble)(ExplicitWork<double>& work, const StepInput& input) = nullptr;
    void (*stepInFloat)(ExplicitWork<float>& work, const StepInput& input) = nullptr;
    Growth growth = nullptr; ///< of those whose bound follows from it
};

/// The step of an integrator that solves, as an equation for velocities w. With f the elastic forces, D the
/// damping, g everything from outside, x and v before the step and ⁺ after it:
///   M·(mass·w − drive) = h·(endShare·f(x⁺) + (1 − endShare)·f(x) − D·w + g),
///   x⁺ = x + drift + reach·w,   v⁺ = w + beyond·(w − v)
/// where `mass` is that of the step's MatrixFactors. With a constant matrix f(x⁺) is replaced by what the
/// matrix says. Led nodes are given w, and end with it.
struct StepForm {
    Vectors drive;       ///< m/s
    Vectors drift;       ///< m; empty: none
    double reach;        ///< s
    double endShare = 1; ///< 0 to 1
    double beyond = 0;
    bool isExact = false;      ///< its order needs all of the tangent, what pressed springs take away too
    bool keepsEnergy = false;  ///< damps nothing: a step in which the tangent's error gains energy is refused
    bool extrapolates = false; ///< takes 2·f(x) − f(x⁻) for the elastic forces
};

/// @param previous before the last step; null where the form builds on none
using FormOf = StepForm (*)(double timeStep, const Motion& before, const Motion* previous);

/// What one integrator is made of: its bounds and its step. Each stands in the file of its name.
struct Scheme {
    /// Largest stable step up to `cap`, s; empty where there is none. @throws Cancelled
    std::optional<double> (*largestStable)(TissueSpectrum& tissue, double cap);
    /// d/c, s, of a viscosity that damps the fastest swings, of so many rad/s, as much as the steps do by
    /// themselves.
    double (*ownDamping)(double timeStep, double frequency);
    /// The matrix of a step of so many seconds: its own where it is constant, else the constant one that
    /// comes closest. Impulses of contact act through it.
    MatrixFactors (*factors)(double timeStep);
    FormOf form = nullptr; ///< of those that solve
    ExplicitMethod explicitMethod = {};
};

inline std::optional<double> alwaysStable(TissueSpectrum& /*tissue*/, double cap) {
    return cap;
}
inline double dampsNothing(double /*timeStep*/, double /*frequency*/) {
    return 0;
}
/// Implicit Euler's: of frequency ω, h·ω²/2 per second off a swing's logarithm, as a viscosity of d/c = h.
inline double dampsAsImplicitEuler(double timeStep, double /*frequency*/) {
    return timeStep;
}
inline MatrixFactors massAlone(double /*timeStep*/) {
    return {1, 0, 0};
}
inline MatrixFactors implicitEulerFactors(double timeStep) {
    return {1, timeStep, timeStep * timeStep};
}
/// x⁺ = x + h·v⁺, driven by v alone: every form of the first order.
StepForm eulerForm(double timeStep, const Motion& before, const Motion* previous);

} // namespace esm

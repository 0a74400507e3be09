#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace esm {

/// How time is stepped. Each has a row of IntegratorTraits in integrators.cpp, and its equations in the file
/// of its name in core/dynamics/schemes.
enum class Integrator {
    Auto, ///< becomes one of the others when a simulation is made
    Euler,
    Verlet,
    Heun,
    Rk4,
    AdamsMoulton,
    Propagation,
    Implicit,
    Bdf2,
    Projective,
    Split,
    Split2,
    Trapezoid
};

/// Those that can be stepped, `Auto` left out.
inline constexpr std::array allIntegrators{
    Integrator::Euler,        Integrator::Verlet,      Integrator::Heun,     Integrator::Rk4,
    Integrator::AdamsMoulton, Integrator::Propagation, Integrator::Implicit, Integrator::Bdf2,
    Integrator::Projective,   Integrator::Split,       Integrator::Split2,   Integrator::Trapezoid};

/// What finds the state after a step: nobody knows yet, accelerations alone, a search node by node, or
/// systems of linear equations.
enum class StepKind { Open, Explicit, Searching, Solving };

/// Where the energy is taken that the steps keep while nothing damps: at a step's end, or in the middle of
/// the step before or of the one that follows.
enum class KeptEnergy { AtEnd, InStepBefore, InStepAfter };

/// All that the program knows of an integrator without stepping it.
struct IntegratorTraits {
    Integrator integrator;
    const char* name;  ///< on the command line and in files
    const char* title; ///< for people, in a word or a few
    StepKind kind;
    int order;           ///< to which power of the step the error of smooth motion falls
    Integrator startsAs; ///< whose steps it takes while there is none to build on; itself: it builds on none
    bool hasConstantMatrix = false; ///< of those that solve: factorised once
    bool mayDampAxially = true;     ///< else springs must damp isotropically
    /// Takes the turning of tissue for a deformation and resists it, so that it lags behind at any but the
    /// shortest steps: it runs where it is asked for by name, with a warning, and is never chosen or
    /// measured.
    bool lagsWhereTissueTurns = false;
    KeptEnergy keptEnergy = KeptEnergy::AtEnd;
    /// s, roughly, of a step per spring. A fixed figure, not measured where it runs, so that all machines
    /// choose alike.
    double stepCost;
    std::array<std::uint8_t, 3> colour; ///< in charts, told apart by people who see few colours as well
    const char* sentence;               ///< for people, begins with the name; empty for `Auto`
};
const IntegratorTraits& traitsOf(Integrator integrator);

/// The command line's name: auto, euler, verlet, …
const char* integratorName(Integrator integrator);
std::optional<Integrator> integratorFromName(const std::string& name);
/// "auto, euler, verlet, …"
std::string integratorNames();

/// To which power of the step the error of smooth motion falls.
int orderOf(Integrator integrator);
/// Nothing but evaluations of the acceleration.
bool isExplicit(Integrator integrator);
/// The same of what `Auto` may become.
bool mayBeExplicit(Integrator integrator);
/// Solves with a matrix that is factorised once.
bool hasConstantMatrix(Integrator integrator);
/// Solves for two matrices: that of its first step after a jump, and its own, which builds on the step
/// before.
bool hasSecondOrderForm(Integrator integrator);

} // namespace esm

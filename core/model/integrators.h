#pragma once

#include <array>
#include <optional>
#include <string>

namespace esm {

/// How time is stepped. With x positions, v velocities, M masses, f elastic forces, D damping, K the tangent
/// of −f, g everything from outside, h the step, ⁺ after it and ⁻ before the last one:
///   a(x,v) = M⁻¹·(f(x) − D·v + g)
enum class Integrator {
    /// Becomes one of the others when a simulation is made.
    Auto,
    /// v⁺ = v + h·a(x,v), x⁺ = x + h·v⁺ [B 4.7]. Semi-implicit, first order.
    Euler,
    /// x⁺ = x + h·v + h²/2·a, a⁺ = a(x⁺, v + h·a), v⁺ = v + h/2·(a + a⁺). Second order, one evaluation.
    Verlet,
    /// ṽ = v + h·a(x,v), x̃ = x + h·v; v⁺ = v + h/2·(a(x,v) + a(x̃,ṽ)), x⁺ = x + h/2·(v + ṽ). Second order.
    Heun,
    /// The classical Runge-Kutta form: four evaluations, fourth order.
    Rk4,
    /// With y = (x,v) and F = (v,a): predicts ỹ = y + h/24·(55F − 59F⁻ + 37F⁻² − 9F⁻³), corrects
    /// y⁺ = y + h/24·(9F̃ + 19F − 5F⁻ + F⁻²). Fourth order, two evaluations; starts with Rk4. [B 4.2]
    AdamsMoulton,
    /// x⁺ = x + h·v⁺, v⁺ = v + h·a(x⁺,v⁺), the fixed point found node by node, starting each pass where the
    /// force is largest or changed most [R 2.3.4]. First order.
    Propagation,
    /// (M + h·D + h²·K)·v⁺ = M·v + h·(f(x) + g), x⁺ = x + h·v⁺: implicit Euler, one Newton step;
    /// in K springs do not buckle. With axial damping up to four, towards f and D at x⁺.
    Implicit,
    /// (3/2·M + h·D + 2/3·h²·K)·v⁺ = M·(2v − v⁻/2) + h·(f(x) − K·(x − x⁻)/3 + g),
    /// x⁺ = (4x − x⁻ + 2h·v⁺)/3, Newton steps as of Implicit. Second order.
    Bdf2,
    /// As Implicit with the weighted graph Laplacian in place of K: a constant matrix, one iteration of
    /// projective dynamics. First order. A spring that is beyond its strain before or after the step counts
    /// with the larger of its constants.
    Projective,
    /// (M + h·D)·v⁺ = M·v + h·(f(x) + g), x⁺ = x + h·v⁺: viscosity implicit, elasticity explicit.
    Split,
    /// (3/2·M + h·D)·v⁺ = M·(2v − v⁻/2) + h·(2f − f⁻ + g), x⁺ = (4x − x⁻ + 2h·v⁺)/3. Second order.
    Split2
};

/// Those that can be stepped, `Auto` left out.
inline constexpr std::array allIntegrators{
    Integrator::Euler,        Integrator::Verlet,      Integrator::Heun,     Integrator::Rk4,
    Integrator::AdamsMoulton, Integrator::Propagation, Integrator::Implicit, Integrator::Bdf2,
    Integrator::Projective,   Integrator::Split,       Integrator::Split2};

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
/// Its matrix is constant: springs must damp isotropically.
bool hasConstantMatrix(Integrator integrator);
/// Solves for two matrices: that of its first step after a jump, and its own, which builds on the step
/// before.
bool hasSecondOrderForm(Integrator integrator);

} // namespace esm

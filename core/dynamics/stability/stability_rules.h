#pragma once

#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability/stability.h"
#include "core/dynamics/step_matrix.h"

namespace esm {

/// The stability rules of one model. Any growth factor of a step is a root of the one-oscillator polynomial
/// at some (k, d) of the joint numerical range of K and D (mass-normalised), so a rule that holds on the
/// whole range, or on a larger set, is safe even where K and D have no common eigenvectors.
class StabilityRules {
public:
    /// @throws Cancelled, as all that follows
    StabilityRules(const SpringSystem& system, Damping damping, StabilitySearch search);
    StabilityRules(const StabilityRules&) = delete;
    StabilityRules& operator=(const StabilityRules&) = delete;

    /// Largest stable step up to `cap`, s; empty where there is none. Precondition: not `Auto`.
    std::optional<double> largestStable(Integrator integrator, double cap);

    /// Largest step up to `cap`, s, at which `implicit` and `bdf2` are sure to solve for the velocities.
    double largestSolvable(double cap) const;

    double largestAngularFrequency() const; ///< rad/s, without damping

private:
    using Matrix = Eigen::SparseMatrix<double>;

    double euler(double cap);
    double verlet(double cap);
    std::optional<double> multistage(Integrator integrator, double cap);
    double propagation(double cap);
    double split(double cap);
    std::optional<double> split2(double cap);
    double split2OnLine(double cap) const;

    /// Largest h up to `cap` up to which mass·M + damping·h·D + stiffness·h²·K is positive definite, which it
    /// is known to be up to `sure`.
    double largestDefinite(const MatrixFactors& factors, double sure, double cap) const;
    double largestDamping();

    StabilitySearch m_search;
    Matrix m_mass, m_damping, m_stiffness;
    double m_largestStiffness = 0;          ///< ω², mass-normalised
    Eigen::VectorXd m_stiffest;             ///< the motion it is of
    std::optional<double> m_largestDamping; ///< 1/s, mass-normalised
    double m_ratio;                         ///< s, smallest d/c
};

} // namespace esm

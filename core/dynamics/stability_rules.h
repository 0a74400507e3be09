#pragma once

#include "core/dynamics/spring_system.h"
#include "core/dynamics/stability.h"
#include "core/dynamics/stability_memory.h"

#include <functional>

namespace esm {

/// The stability rules of one model. Any growth factor of a step is a root of the one-oscillator polynomial
/// at some (k, d) of the joint numerical range of K and D (mass-normalised), so a rule that holds on the
/// whole range, or on a larger set, is safe even where K and D have no common eigenvectors.
class StabilityRules {
public:
    StabilityRules(const SpringSystem& system, Damping damping, StabilitySearch search);
    StabilityRules(const StabilityRules&) = delete;
    StabilityRules& operator=(const StabilityRules&) = delete;

    /// Largest stable step up to `cap`, s; empty where there is none. Precondition: not `Auto`.
    std::optional<double> largestStable(Integrator integrator, double cap);

    /// Largest step up to `cap`, s, at which `implicit` and `bdf2` are sure to solve for the velocities.
    double largestSolvable(double cap) const;

    double largestAngularFrequency() const; ///< rad/s, without damping

private:
    using Matrix = StabilityMemory::Matrix;

    double euler(double cap);
    double verlet(double cap);
    std::optional<double> multistage(Integrator integrator, double cap);
    double propagation(double cap);
    double split(double cap);
    std::optional<double> split2(double cap);
    double split2OnLine(double cap) const;

    /// Largest h ≥ `guess`, up to `cap`, for which `holds`, which is true below some step and false above it;
    /// short of it by at most the tolerance, relative. What a former search found is tried first.
    double largestStep(Integrator integrator, double guess, double cap,
                       const std::function<bool(double)>& holds);
    void analyse();
    /// An upper estimate of λmax, mass-normalised.
    double largestOf(const Matrix& matrix, Eigen::VectorXd& eigenvector) const;

    /// Whether massFactor·M + dampingFactor·D + stiffnessFactor·K is positive definite.
    bool isDefinite(double massFactor, double dampingFactor, double stiffnessFactor);
    double largestDamping();

    StabilitySearch m_search;
    StabilityMemory m_ownMemory; ///< where the search brings none
    StabilityMemory& m_memory;
    int m_factorisations = 0;
    Matrix m_mass, m_damping, m_stiffness;
    double m_largestStiffness;              ///< ω², mass-normalised
    std::optional<double> m_largestDamping; ///< 1/s, mass-normalised
    double m_ratio;                         ///< s, smallest d/c
};

} // namespace esm

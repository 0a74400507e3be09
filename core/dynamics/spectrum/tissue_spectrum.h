#pragma once

#include "core/dynamics/settings.h"
#include "core/dynamics/spectrum/stability_search.h"
#include "core/dynamics/spectrum/symmetric_sum.h"
#include "core/dynamics/spring_system.h"
#include "core/dynamics/step_matrix.h"

#include <memory>
#include <optional>

namespace esm {

/// One tissue as its integrators' bounds see it: a family of damped oscillators. Any growth factor of a step
/// is a root of the one-oscillator polynomial at some (k, d) of the joint numerical range of K and D
/// (mass-normalised), so a bound that holds on the whole range, or on a larger set, is safe even where K and
/// D have no common eigenvectors.
class TissueSpectrum {
public:
    /// @throws Cancelled, as all that follows
    TissueSpectrum(const SpringSystem& system, Damping damping, StabilitySearch search);
    TissueSpectrum(const TissueSpectrum&) = delete;
    TissueSpectrum& operator=(const TissueSpectrum&) = delete;

    /// The same tissue without the stiffness of its fluids: what is left of it for steps that take this
    /// implicitly.
    TissueSpectrum& withoutFluids() { return m_withoutFluids ? *m_withoutFluids : *this; }

    double largestStiffness() const { return m_largestStiffness; } ///< ω², 1/s²
    double largestAngularFrequency() const;                        ///< rad/s, without damping
    double largestDamping();                                       ///< 1/s, mass-normalised
    double dampingRatio() const { return m_ratio; }                ///< s, smallest d/c of springs and fluids
    double tolerance() const { return m_search.tolerance; }
    Deformation deformation() const { return m_search.deformation; }

    /// Largest h up to `cap`, s, up to which mass·M + damping·h·D + stiffness·h²·K is positive definite,
    /// which it is known to be up to `sure`.
    double largestDefinite(const MatrixFactors& factors, double sure, double cap) const;

    /// Whether every motion has h·d ≥ `least` at a step of h, s.
    bool isDampedBeyond(double least, double timeStep) const;

private:
    using Matrix = Eigen::SparseMatrix<double>;

    StabilitySearch m_search;
    Matrix m_mass, m_damping;
    Matrix m_springDamping; ///< that of hinges left out
    SymmetricSum m_stiffness;
    double m_largestStiffness = 0;
    Eigen::VectorXd m_stiffest; ///< the motion it is of
    std::optional<double> m_largestDamping;
    double m_ratio;
    std::unique_ptr<TissueSpectrum> m_withoutFluids; ///< null where there is no such stiffness
};

} // namespace esm

#include "core/dynamics/spectrum/tissue_spectrum.h"

#include "core/dynamics/spectrum/definite_step.h"
#include "core/dynamics/spectrum/largest_eigenvalue.h"
#include "core/dynamics/spectrum/rest_matrix.h"

#include <cmath>

namespace esm {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

Matrix massNormalised(const Matrix& matrix, const Matrix& mass) {
    const Eigen::VectorXd scale = mass.diagonal().cwiseSqrt().cwiseInverse();
    return Matrix(scale.asDiagonal() * matrix * scale.asDiagonal());
}

SpringSystem withoutHinges(SpringSystem system) {
    system.hinges.clear();
    return system;
}

} // namespace

// With y = √M·x the eigenvalues of M⁻¹K are those of the symmetric M^(−1/2)·K·M^(−1/2), which Lanczos' method
// can take: ω² of the swings without damping. The motion of the largest one is kept. It starts every search
// for a longest step, since it is next to the motion that limits it.
TissueSpectrum::TissueSpectrum(const SpringSystem& system, Damping damping, StabilitySearch search)
    : m_search(std::move(search)) {
    const bool isAtRest = m_search.deformation == Deformation::AtRest;
    const auto matrixOf = [&](const SpringSystem& tissue, const MatrixFactors& factors) {
        return isAtRest ? restMatrix(tissue, damping, factors)
                        : laplacianMatrix(tissue, factors, tissue.fixed);
    };
    const auto matrix = [&](const MatrixFactors& factors) { return matrixOf(system, factors); };
    m_mass = matrix({1, 0, 0});
    m_damping = matrix({0, 1, 0});
    m_stiffness = matrix({0, 0, 1});
    m_springDamping = system.hinges.empty() ? m_damping : matrixOf(withoutHinges(system), {0, 1, 0});
    reportProgress(m_search.progress, 0);
    Eigenpair stiffest = largestEigenpair(massNormalised(m_stiffness, m_mass), m_search.tolerance / 2);
    m_largestStiffness = stiffest.value;
    if (stiffest.value > 0) m_stiffest = stiffest.vector.cwiseQuotient(m_mass.diagonal().cwiseSqrt());
    // Moved across their axes, springs that damp along them alone have no damping.
    m_ratio = isAtRest || damping == Damping::Isotropic ? leastDampingRatio(system) : 0;
}

double TissueSpectrum::largestAngularFrequency() const {
    return std::sqrt(m_largestStiffness);
}

// Hinges only add to the damping, but their matrix has positive entries beside its diagonal.
bool TissueSpectrum::isDampedBeyond(double least, double timeStep) const {
    return esm::isDampedBeyond(least, timeStep, m_mass, m_springDamping);
}

double TissueSpectrum::largestDefinite(const MatrixFactors& factors, double sure, double cap) const {
    if (m_largestStiffness == 0) return std::min(sure, cap);
    const StepFamily family{m_mass, m_damping, m_stiffness, factors};
    return largestDefiniteStep(family, m_stiffest, {sure, cap, m_search.tolerance, m_search.progress});
}

double TissueSpectrum::largestDamping() {
    if (m_largestDamping) return *m_largestDamping;
    reportProgress(m_search.progress, 0);
    m_largestDamping = largestEigenvalue(massNormalised(m_damping, m_mass), m_search.tolerance / 2);
    return *m_largestDamping;
}

} // namespace esm

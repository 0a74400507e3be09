#include "core/dynamics/spectrum/tissue_spectrum.h"

#include "core/dynamics/spectrum/definite_step.h"
#include "core/dynamics/spectrum/fluid_stiffness.h"
#include "core/dynamics/spectrum/largest_eigenvalue.h"
#include "core/dynamics/spectrum/rest_matrix.h"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

Eigen::VectorXd massScale(const Matrix& mass) {
    return mass.diagonal().cwiseSqrt().cwiseInverse();
}

SpringSystem withSoftFluids(SpringSystem system) {
    for (SpringSystem::Filled& cavity : system.cavities)
        cavity.stiffness = 0;
    return system;
}

bool hasStiffFluids(const SpringSystem& system) {
    return std::any_of(system.cavities.begin(), system.cavities.end(),
                       [](const auto& cavity) { return cavity.stiffness > 0; });
}

// A fluid has no viscosity; what ends its swings is that of its wall. Of the motion x it damps with xᵀDx what
// the fluid resists with (cᵀx)², which is at most cᵀD⁻¹c of it (Cauchy and Schwarz). D⁻¹c is enough to a
// hundredth. Where D is singular, no wall's volume changes by what it lets go undamped, as by moving as a
// whole.
double leastRatioWithFluids(double ofSprings, const Matrix& damping, const Eigen::MatrixXd& columns) {
    if (ofSprings == 0 || columns.cols() == 0) return ofSprings;
    Eigen::ConjugateGradient<Matrix, Eigen::Lower> solver(damping);
    solver.setTolerance(0.01);
    double inverse = 1 / ofSprings;
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
        inverse += columns.col(i).dot(solver.solve(columns.col(i)));
    return 1 / inverse;
}

SpringSystem withoutHinges(SpringSystem system) {
    system.hinges.clear();
    return system;
}

} // namespace

// With y = √M·x the eigenvalues of M⁻¹K are those of the symmetric M^(−1/2)·K·M^(−1/2), which Lanczos' method
// can take: ω² of the swings without damping. The motion of the largest one is kept. It starts every search
// for a longest step, since it is next to the motion that limits it.
//
// Fluids press across x, y and z, so that with them there are three rows for a node at any deformation too.
// How their pressures turn with the wall is left out of the damping ratio: only slow motions have much of it
// beside their springs, and those are far from any step's limit.
TissueSpectrum::TissueSpectrum(const SpringSystem& system, Damping damping, StabilitySearch search)
    : m_search(std::move(search)) {
    const bool isAtRest = m_search.deformation == Deformation::AtRest;
    const auto matrixOf = [&](const SpringSystem& tissue, const MatrixFactors& factors) {
        if (isAtRest) return restMatrix(tissue, damping, factors);
        const Matrix ofOneAxis = laplacianMatrix(tissue, factors, tissue.fixed);
        return tissue.cavities.empty() ? ofOneAxis : forThreeAxes(ofOneAxis);
    };
    const auto matrix = [&](const MatrixFactors& factors) { return matrixOf(system, factors); };
    m_mass = matrix({1, 0, 0});
    m_damping = matrix({0, 1, 0});
    m_springDamping = system.hinges.empty() ? m_damping : matrixOf(withoutHinges(system), {0, 1, 0});
    m_stiffness.lower = matrix({0, 0, 1});
    if (!system.cavities.empty()) {
        SymmetricSum fluids = fluidStiffness(system, m_search.deformation);
        m_stiffness.lower += fluids.lower;
        m_stiffness.columns = std::move(fluids.columns);
    }
    reportProgress(m_search.progress, 0);
    const Eigen::VectorXd scale = massScale(m_mass);
    Eigenpair stiffest = largestEigenpair(scaled(m_stiffness, scale), m_search.tolerance / 2);
    m_largestStiffness = stiffest.value;
    if (stiffest.value > 0) m_stiffest = stiffest.vector.cwiseProduct(scale);
    // Moved across their axes, springs that damp along them alone have no damping.
    const double ofSprings = isAtRest || damping == Damping::Isotropic ? leastDampingRatio(system) : 0;
    m_ratio = leastRatioWithFluids(ofSprings, m_damping, m_stiffness.columns);
    if (hasStiffFluids(system))
        m_withoutFluids = std::make_unique<TissueSpectrum>(withSoftFluids(system), damping, m_search);
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
    m_largestDamping = largestEigenvalue(scaled(m_damping, massScale(m_mass)), m_search.tolerance / 2);
    return *m_largestDamping;
}

} // namespace esm

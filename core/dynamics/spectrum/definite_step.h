#pragma once

#include "core/dynamics/spectrum/symmetric_sum.h"
#include "core/dynamics/step_matrix.h"
#include "core/support/progress.h"

namespace esm {

/// The symmetric matrices Q(h) = mass·M + damping·h·D + stiffness·h²·K of a step of h seconds: M diagonal and
/// positive, D positive semidefinite, `mass` positive. Lower halves.
struct StepFamily {
    const Eigen::SparseMatrix<double>& mass;
    const Eigen::SparseMatrix<double>& damping;
    const SymmetricSum& stiffness;
    MatrixFactors factors;
};

/// s, the least h at which xᵀQ(h)x is zero; infinite where it never is. Q is definite at no longer step.
double firstZero(const StepFamily& family, const Eigen::VectorXd& x);

struct DefiniteSearch {
    double sure;      ///< s; up to here Q is known to be definite
    double cap;       ///< s; nothing beyond is looked at
    double tolerance; ///< relative; a step is found too short by at most this
    Progress progress;
};

/// Largest h up to the cap up to which Q is positive definite. `near` is a motion whose first zero starts the
/// search. @throws Cancelled
double largestDefiniteStep(const StepFamily& family, const Eigen::VectorXd& near,
                           const DefiniteSearch& search);

/// Whether share·M is below h·D for every motion. Precondition: nothing beside the diagonal of D is positive.
bool isDampedBeyond(double share, double h, const Eigen::SparseMatrix<double>& mass,
                    const Eigen::SparseMatrix<double>& damping);

} // namespace esm

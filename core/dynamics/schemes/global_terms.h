#pragma once

#include "core/dynamics/schemes/step_solver.h"

#include <Eigen/Dense>

namespace esm {

/// σ·g·gᵀ, of rank one, beside the matrix of a step: what moves far apart from each other it ties together,
/// and no sparse matrix holds it. A fluid's stiffness is one, with σ the fall of its pressure by volume, in
/// Pa/m³, times the matrix's own factor of stiffness.
struct GlobalTerm {
    double factor;    ///< σ, kg/m⁴
    Vectors gradient; ///< g, m², one per node
};
using GlobalTerms = std::vector<GlobalTerm>;

/// Of the fluids that resist, at these places. @param stiffnessFactor s², of K in the step's matrix
GlobalTerms globalTermsOf(const SpringSystem& system, const Vectors& positions, double stiffnessFactor);

/// From solutions with a matrix A to those with A + Σ σ·g·gᵀ (Sherman and Morrison 1950, Woodbury 1950).
class GlobalCorrection {
public:
    GlobalCorrection() = default;
    /// @param responses A⁻¹·g of each term, 0 where velocities are given
    GlobalCorrection(const GlobalTerms& terms, std::vector<Vectors> responses);

    /// Of each term's response, how much a solution with A alone has too much.
    Eigen::VectorXd excess(const GlobalTerms& terms, const Vectors& solution) const;
    /// Takes that off.
    void correct(const GlobalTerms& terms, Vectors& solution) const;

private:
    std::vector<Vectors> m_responses;
    Eigen::LLT<Eigen::MatrixXd> m_coupling; ///< 1/σ + gᵀ·A⁻¹·g, between the terms
};

/// Solves for a step's velocities with its constant matrix and the terms beside it. Given and led nodes' are
/// given in `velocities`; `half` is the half-solved step, for impulses on single nodes.
void solveStep(StepSolver& solver, const std::vector<PrescribedNode>& prescribed, const GlobalTerms& terms,
               const Vectors& momentum, Vectors& velocities, Vectors& half);

double scalarProduct(const Vectors& a, const Vectors& b);
/// target += factor·vectors
void addMultiple(Vectors& target, double factor, const Vectors& vectors);

} // namespace esm

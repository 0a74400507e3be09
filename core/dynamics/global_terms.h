#pragma once

#include "core/dynamics/spring_system.h"

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
    GlobalCorrection(GlobalTerms terms, std::vector<Vectors> responses);

    bool isEmpty() const { return m_terms.empty(); }
    const GlobalTerms& terms() const { return m_terms; }
    const std::vector<Vectors>& responses() const { return m_responses; }

    /// Of each term's response, how much a solution with A alone has too much.
    Eigen::VectorXd excess(const Vectors& solution) const;
    /// The same by the solution's products with the gradients, one in each row: of many solutions at once.
    Eigen::MatrixXd excessOf(const Eigen::MatrixXd& products) const { return m_coupling.solve(products); }
    /// Takes that off.
    void correct(Vectors& solution) const;

private:
    GlobalTerms m_terms;
    std::vector<Vectors> m_responses;
    Eigen::LLT<Eigen::MatrixXd> m_coupling; ///< 1/σ + gᵀ·A⁻¹·g, between the terms
};

double scalarProduct(const Vectors& a, const Vectors& b);
/// target += factor·vectors
void addMultiple(Vectors& target, double factor, const Vectors& vectors);

} // namespace esm

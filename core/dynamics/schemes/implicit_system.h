#pragma once

#include "core/dynamics/global_terms.h"
#include "core/dynamics/hinge_force.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/settings.h"
#include "core/dynamics/spring_force.h"
#include "core/dynamics/step_matrix.h"

namespace esm {

/// A = massFactor·M + dampingFactor·D + stiffnessFactor·K at one place of the tissue: K is the tangent
/// stiffness, −∂f/∂x, and D may damp along the springs alone. Never factorised. Of a fluid K has the
/// stiffness, of rank one, and the turning of its pressure with the wall.
class TangentMatrix {
public:
    TangentMatrix(const SpringSystem& system, Damping damping, const MatrixFactors& factors,
                  const Vectors& positions);

    /// Takes in how the pressures of loads turn with the walls, so far through a step.
    void addLoads(const Loads& loads, double endShare);

    /// A·velocities
    void multiply(const Vectors& velocities, Vectors& product) const;
    /// K·displacements, N
    Vectors stiffnessTimes(const Vectors& displacements) const;

    /// What of A is of low rank: the stiffness of fluids.
    const GlobalTerms& globalTerms() const { return m_globalTerms; }

    /// Leaves out of K what pressed springs and strained hinges take away. A is then positive definite, but
    /// for pressures.
    void omitBuckling();
    /// Leaves out how pressures turn with their walls as well. That takes away what stretched springs resist
    /// with when a filled part turns as a whole: without it, such a part is slowed.
    void makeDefinite();

private:
    void addSprings(const MatrixFactors& factors, const Vectors& velocities, Vectors& product) const;
    void addHinges(const MatrixFactors& factors, const Vectors& velocities, Vectors& product) const;
    void addFluids(double stiffnessFactor, const Vectors& velocities, Vectors& product) const;

    const SpringSystem& m_system;
    Damping m_damping;
    MatrixFactors m_factors;
    const Vectors m_positions;             ///< m; none without cavities
    std::vector<SpringTangent> m_tangents; ///< by spring
    std::vector<BentHinge> m_bent;         ///< by hinge
    bool m_omitsBuckling = false;
    std::vector<double> m_pressures; ///< Pa, by cavity, that turn with the wall
    GlobalTerms m_globalTerms;
};

/// Solves A·v = momentum for the nodes whose velocities neither the matrix nor `prescribed` gives, by
/// conjugate gradients preconditioned with the factorised matrix, in which the weighted Laplacian stands for
/// K. Starts from that matrix's own solution, which has the momentum of the whole already.
/// @param tolerance of the preconditioned residual's norm
/// @throws InvalidModel when it does not converge
void solveImplicit(TangentMatrix& matrix, const StepMatrix& preconditioner,
                   const std::vector<PrescribedNode>& prescribed, const Vectors& momentum,
                   Vectors& velocities, double tolerance = 1e-10);

} // namespace esm

#pragma once

#include "core/dynamics/hinge_force.h"
#include "core/dynamics/motion.h"
#include "core/dynamics/settings.h"
#include "core/dynamics/spring_force.h"
#include "core/dynamics/step_matrix.h"

namespace esm {

/// A = massFactor·M + dampingFactor·D + stiffnessFactor·K at one place of the tissue: K is the tangent
/// stiffness, −∂f/∂x, and D may damp along the springs alone. Never factorised.
class TangentMatrix {
public:
    TangentMatrix(const SpringSystem& system, Damping damping, const MatrixFactors& factors,
                  const Vectors& positions);

    /// A·velocities
    void multiply(const Vectors& velocities, Vectors& product) const;
    /// K·displacements, N
    Vectors stiffnessTimes(const Vectors& displacements) const;

    /// Leaves out of K what pressed springs and strained hinges take away, so that A is positive definite.
    void omitBuckling();

private:
    void addSprings(const MatrixFactors& factors, const Vectors& velocities, Vectors& product) const;
    void addHinges(const MatrixFactors& factors, const Vectors& velocities, Vectors& product) const;

    const SpringSystem& m_system;
    Damping m_damping;
    MatrixFactors m_factors;
    std::vector<SpringTangent> m_tangents; ///< by spring
    std::vector<BentHinge> m_bent;         ///< by hinge
    bool m_omitsBuckling = false;
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

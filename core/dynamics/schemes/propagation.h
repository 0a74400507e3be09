#pragma once

#include "core/dynamics/node_ties.h"
#include "core/dynamics/schemes/step_scheme.h"
#include "core/dynamics/settings.h"

#include <functional>

namespace esm {

/// The two-phase propagation of the source [R 2.3.4]. Within a step the local propagation lets each node take
/// the velocity that its springs' present forces ask of it, pass after pass, until no node's force changes
/// any more; then all nodes move on. The first pass starts at the node with the largest force, later ones
/// where the force changed most, and go on outwards along the springs. What the node's own motion changes in
/// its force is taken into account at once, so that stiff tissue settles as well.
class PropagationScheme : public StepScheme {
public:
    /// @param isWanted asked now and then within a step; may be empty
    PropagationScheme(const SpringSystem& system, Damping damping, std::function<bool()> isWanted = {});

    /// @throws InvalidModel when the forces do not settle; Cancelled when it is not wanted any more
    UntouchedStep step(const SpringSystem& system, const StepInput& input, const Motion& before,
                       StepperSolvers& solvers) override;

private:
    class LocalPropagation;

    std::vector<std::uint32_t> outwardsFrom(std::uint32_t node) const;
    /// The node's entry on the diagonal of massFactor·M + dampingFactor·D + stiffnessFactor·K, as if springs
    /// were stiff every way.
    double diagonalOf(std::uint32_t node, const SpringSystem& system, const MatrixFactors& factors) const;
    Eigen::Vector3d forceOn(std::uint32_t node, const SpringSystem& system, const Motion& motion) const;

    Damping m_damping;
    std::function<bool()> m_isWanted;
    NodeTies m_ties;
};

} // namespace esm

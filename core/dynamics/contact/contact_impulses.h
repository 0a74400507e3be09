#pragma once

#include "core/dynamics/contact/contact.h"
#include "core/dynamics/contact/node_impulses.h"
#include "core/dynamics/global_terms.h"

namespace esm {

/// What a fluid of which the step's matrix knows nothing adds to every answer: pushed in at one place, its
/// wall goes out at all others within the same step.
struct FluidAnswers {
    GlobalCorrection correction;        ///< velocities
    std::vector<Vectors> halfResponses; ///< half-solved, of each term

    bool isEmpty() const { return correction.isEmpty(); }
    /// So much of each term's, of a half-solved step.
    void takeOff(const Eigen::VectorXd& shares, Vectors& half) const {
        for (std::size_t i = 0; i < halfResponses.size(); ++i)
            addMultiple(half, -shares[static_cast<Eigen::Index>(i)], halfResponses[i]);
    }
};

/// Gives each contact's point at least the change of velocity, m/s along its normal, that it needs, by
/// impulses that only push, and push only where they must; the led nodes keep their velocities. Frictionless;
/// a linear complementarity problem over A⁻¹, with what fluids add to A, solved by projected Gauss-Seidel
/// from `impulses` (N·s, one per contact), which take the result. The impulses are laid on `half`, a
/// half-solved step.
struct ContactProblem {
    const std::vector<Contact>& contacts;
    const Eigen::VectorXd& needed; ///< m/s
    const std::vector<std::uint32_t>& led;
    const std::vector<char>& immovable; ///< nodes that do not answer, the led ones among them
    double tolerance;                   ///< m/s
    const FluidAnswers& fluids;
};
void pushContacts(const ContactProblem& problem, NodeImpulses& response, Eigen::VectorXd& impulses,
                  Vectors& half);

/// Lays impulses that are known on a half-solved step.
void layImpulses(const ContactProblem& problem, NodeImpulses& response, const Eigen::VectorXd& impulses,
                 Vectors& half);

} // namespace esm

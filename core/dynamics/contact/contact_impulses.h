#pragma once

#include "core/dynamics/contact/contact.h"
#include "core/dynamics/contact/node_impulses.h"

namespace esm {

/// Gives each contact's point at least the change of velocity, m/s along its normal, that it needs, by
/// impulses that only push, and push only where they must; the led nodes keep their velocities. Frictionless;
/// a linear complementarity problem over A⁻¹, solved by projected Gauss-Seidel from `impulses` (N·s, one per
/// contact), which take the result. The impulses are laid on `half`, a half-solved step.
struct ContactProblem {
    const std::vector<Contact>& contacts;
    const Eigen::VectorXd& needed; ///< m/s
    const std::vector<std::uint32_t>& led;
    const std::vector<char>& immovable; ///< nodes that do not answer, the led ones among them
    double tolerance;                   ///< m/s
};
void pushContacts(const ContactProblem& problem, NodeImpulses& response, Eigen::VectorXd& impulses,
                  Vectors& half);

/// Lays impulses that are known on a half-solved step.
void layImpulses(const ContactProblem& problem, NodeImpulses& response, const Eigen::VectorXd& impulses,
                 Vectors& half);

} // namespace esm

#pragma once

#include "core/solid/rigidity.h"

namespace esm {

/// For each node, whether it belongs to what is shown to be rigid of its body: nodes that cannot move against
/// each other without stretching a spring, at small motion. No more than one such group is named of each
/// body, the largest that is found, or none. What is left may be as rigid.
/// @param bodies what springs hold together, each a list of nodes
std::vector<char> rigidCores(const std::vector<Eigen::Vector3d>& nodes,
                             const std::vector<LatticeSpring>& springs,
                             const std::vector<std::vector<std::uint32_t>>& bodies);

} // namespace esm

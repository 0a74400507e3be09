#pragma once

#include "core/dynamics/spring_system.h"

namespace esm {

/// Nodes in the order of reverse Cuthill-McKee: the node at each place. Springs then join nodes whose places
/// are close. Components follow each other; the order depends on nothing but the springs and node numbers.
std::vector<std::uint32_t> reverseCuthillMcKee(const SpringSystem& system);

} // namespace esm

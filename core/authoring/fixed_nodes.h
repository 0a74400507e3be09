#pragma once

#include "core/project/project.h"

namespace esm {

/// Those that lie within a radius (m) of a path over the organ at rest, a line from one point to the next;
/// sorted.
std::vector<std::uint32_t> nodesAlong(const SpringNetwork& network, const std::vector<Eigen::Vector3d>& path,
                                      double radius);

/// Holds nodes in space, beside those that are held already.
void fixNodes(Project& project, const std::vector<std::uint32_t>& nodes);

/// Lets nodes go. Where an ellipsoid held one of them, its nodes are held one by one from now on.
void freeNodes(Project& project, const std::vector<std::uint32_t>& nodes);

} // namespace esm

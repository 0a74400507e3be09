#pragma once

#include "core/solid/rigidity.h"

#include "core/model/lattice.h"

namespace esm {

/// The springs of a wall of prisms: the edges of its tetrahedra, each once, the smaller node first.
/// @param nodes layer by layer, as many in each
/// @param triangles over those of the first layer
/// @throws Cancelled
std::vector<LatticeSpring> prismSprings(const std::vector<Eigen::Vector3d>& nodes,
                                        const std::vector<Triangle>& triangles,
                                        const std::vector<std::uint32_t>& order,
                                        const LatticeFilling& filling, const Progress& progress);

} // namespace esm

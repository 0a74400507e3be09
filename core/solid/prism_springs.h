#pragma once

#include "core/model/lattice.h"
#include "core/solid/rigidity.h"

namespace esm {

/// The springs of a wall of prisms under each triangle: the edges of their tetrahedra, each once, the smaller
/// node first; of prisms that are left out too.
/// @param nodes layer by layer, as many in each
/// @param triangles over those of the first layer
/// @param order of the vertices: diagonals lead inwards from lower to higher
/// @throws Cancelled
std::vector<LatticeSpring> prismSprings(const std::vector<Eigen::Vector3d>& nodes,
                                        const std::vector<Triangle>& triangles,
                                        const std::vector<std::uint32_t>& order,
                                        const LatticeFilling& filling, const Progress& progress);

} // namespace esm

#pragma once

#include "core/solid/lattice_springs.h"

namespace esm {

/// Lets a cut lattice go to where its springs balance, the nodes on the surface sliding along it. No
/// tetrahedron becomes worse by it than it was or than `leastShape`, and none is turned over.
/// @param spacing of the lattice, m
/// @throws Cancelled
void relax(StuffedLattice& lattice, const std::vector<FittedSpring>& springs, const BodyQuery& query,
           double spacing, const Progress& progress);

/// 1 for a regular tetrahedron, 0 for a flat one, negative when turned over: its volume over that of a
/// regular one whose edges have the same mean square.
double shapeOf(const Tetrahedron& tetrahedron, const std::vector<Eigen::Vector3d>& nodes);

} // namespace esm

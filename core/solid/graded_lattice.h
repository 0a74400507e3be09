#pragma once

#include "core/solid/background_lattice.h"

namespace esm {

/// A body-centred lattice whose cubes double in width with the depth, up to `mostDoublings` times.
/// @param spacing between nearest neighbours at the surface, m
/// @throws InvalidModel where the box around the body has too many sites; Cancelled
BackgroundLattice gradedLattice(double spacing, const ClosedBody& body, const BodyQuery& query,
                                const Progress& progress);

/// How deep places lie that are spread evenly over a body, m, the least first; of a very thin one none.
/// @param places of the box around it
std::vector<double> depthsWithin(const ClosedBody& body, std::size_t places);

/// Nodes of a graded lattice over those of an even one, less what the surface adds to both.
/// @param depths `depthsWithin()` the body
double gradedShare(const std::vector<double>& depths, double spacing);

} // namespace esm

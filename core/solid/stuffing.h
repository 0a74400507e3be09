#pragma once

#include "core/solid/background_lattice.h"

namespace esm {

/// A lattice cut to a body's surface.
struct StuffedLattice {
    std::vector<Eigen::Vector3d> nodes; ///< m
    std::vector<char> isOnSurface;      ///< per node; these lie on it to the last digits
    std::vector<std::uint32_t> points;  ///< per node the background's point that it came from; noIndex: a cut
    std::vector<Tetrahedron> tetrahedra;
    std::vector<std::uint32_t> origins; ///< per tetrahedron the background's that it came from
    std::vector<char> isWhole;          ///< per tetrahedron, whether it is all of that one
};

/// Cuts a lattice to the surface of a body.
/// @throws Cancelled
StuffedLattice stuffed(BackgroundLattice& background, const BodyQuery& query, const Progress& progress);

} // namespace esm

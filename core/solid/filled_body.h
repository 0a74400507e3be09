#pragma once

#include "core/solid/background_lattice.h"
#include "core/solid/lattice_estimate.h"
#include "core/solid/rigidity.h"

#include <cstddef>

namespace esm {

/// Nodes, springs and tetrahedra that fill what a surface encloses.
struct FilledBody {
    std::vector<Eigen::Vector3d> nodes; ///< m; springs are at rest where they are
    std::vector<char> isOnSurface;      ///< per node; these lie on the surface, all others within
    std::vector<LatticeSpring> springs; ///< each once, the smaller node first
    std::vector<Tetrahedron> tetrahedra;
    std::vector<std::uint32_t> bodyStarts; ///< the first node of each body, then how many there are
    double enclosedVolume = 0;             ///< of the surface, cavities left out, m³
};

/// A lattice of about so many nodes, its spacing to two digits; of a thin body more.
/// @throws InvalidModel for a surface that is open or encloses nothing
LatticeFilling fillingOf(const TriangleMesh& mesh, LatticeKind kind, double nodes = usualLatticeNodes);

/// Before anything is filled.
/// @throws InvalidModel as fillBody() does, except where there would be too many nodes; Cancelled
LatticeEstimate estimateLattice(const TriangleMesh& mesh, const LatticeFilling& filling,
                                const Progress& progress = {});

/// None for prisms, which leave out triangles that meet.
/// @throws InvalidModel as `fillBody()` does for surface and spacing, except for too many nodes
NarrowCrossings narrowCrossings(const TriangleMesh& mesh, const LatticeFilling& filling,
                                const Progress& progress = {});

/// Fills every body that a closed surface encloses with a lattice of its own. Nodes lie within or on the
/// surface; no spring leaves the body (`leavesBody()`); all springs are at rest. Where the surface runs
/// through itself in narrow places (`Crossing`) a node may lie outside by a quarter of the spacing. Constants
/// are relative to one between nearest neighbours of the lattice, and such that tissue has the same modulus
/// everywhere (`elasticityOf()`): less at the surface, where a spring has tissue on one side alone. Bodies
/// too small for the spacing get a finer lattice. The same input gives the same result on any number of
/// threads.
/// @throws InvalidModel for a spacing that is no positive number, is wider than the organ or needs more than
/// `mostLatticeNodes`, and for a surface that is open, runs through itself more widely, or encloses nothing
/// @throws Cancelled
FilledBody fillBody(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress = {});

} // namespace esm

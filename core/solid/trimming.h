#pragma once

#include "core/solid/stuffing.h"

namespace esm {

/// A straight way between two nodes of a body.
struct BodySegment {
    Eigen::Vector3d from, to; ///< m
    bool isFromInside;        ///< the first end lies within, not on the surface
};

/// How far outside a spring of a lattice may run, m: of body-centred ones a quarter of the spacing, of others
/// as much more as their longest springs are longer.
double deepestChord(LatticeKind kind, double spacing);

/// Whether a spring leaves the body: where it is outside it lies farther than `deepest` (m) from the surface,
/// or it runs through a gap from wall to wall. Where the surface bends inwards a spring between two nodes on
/// it is a chord, which is outside by little; that does not count.
bool leavesBody(const BodyQuery& query, const BodySegment& segment, double deepest);

/// Leaves out tetrahedra of which an edge with a suspect node leaves the body, then what no longer hangs
/// together with the rest face to face, then nodes without a tetrahedron.
/// @param isSuspect per node
/// @throws Cancelled
void trim(StuffedLattice& lattice, const std::vector<char>& isSuspect, const BodyQuery& query, double deepest,
          const Progress& progress);

} // namespace esm

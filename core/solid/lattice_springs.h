#pragma once

#include "core/solid/rigidity.h"
#include "core/solid/stuffing.h"

namespace esm {

/// A spring of a lattice that was cut to a body.
struct FittedSpring {
    LatticeSpring spring;
    double latticeLength; ///< m, of what the lattice has there; 0 where it has none
};

/// Every spring once, by its nodes, the smaller first.
std::vector<FittedSpring> fittedSprings(const BackgroundLattice& background, const StuffedLattice& lattice);

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

/// A spring of a lattice, at rest where its nodes are.
struct LatticeSpring {
    std::uint32_t first, second; ///< nodes
    double constant;             ///< relative: 1 between nearest neighbours within the lattice
};

struct Rigidity {
    std::size_t bodies = 0;      ///< what springs hold together; a node without springs is one
    std::size_t floppyModes = 0; ///< ways to move without stretching a spring, beyond moving each body whole
};

/// Counts them at small motion. A mode counts as floppy where it is softer than the stiffest node by more
/// than 10⁻¹⁰ of it.
/// @throws InvalidModel when the matrix could not be factored; Cancelled
Rigidity rigidityOf(const std::vector<Eigen::Vector3d>& nodes, const std::vector<LatticeSpring>& springs,
                    const Progress& progress = {});

} // namespace esm

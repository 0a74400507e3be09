#pragma once

#include "core/model/lattice.h"
#include "core/solid/closed_body.h"
#include "core/support/progress.h"

#include <array>
#include <vector>

namespace esm {

/// What a tetrahedron that is whole gives to a spring.
struct LatticeShare {
    std::uint32_t first, second; ///< points
    double constant;             ///< relative
    double length;               ///< m, as the lattice has it
};

/// A lattice over a body and somewhat beyond, before it is cut to its surface.
struct BackgroundLattice {
    std::vector<Eigen::Vector3d> points;       ///< m
    std::vector<char> isInside;                ///< per point, whether the body holds it
    std::vector<Tetrahedron> tetrahedra;       ///< with a corner inside, face to face
    std::vector<double> volumes;               ///< of each, as the lattice has it, m³
    std::vector<std::uint32_t> shareStarts{0}; ///< where those of each tetrahedron begin; then the end
    std::vector<LatticeShare> shares;
    /// What a tetrahedron that is not whole gives to a spring along its edge: this times volume over squared
    /// length, relative, in 1/m.
    double cutStiffness = 0;
    /// Whether tetrahedra at the surface count as cut: the lattice alone would leave nodes there loose.
    bool hasSkin = false;
};

/// @param spacing between nearest neighbours, m
/// @throws InvalidModel where the box around the body has too many sites; Cancelled
BackgroundLattice uniformLattice(LatticeKind kind, double spacing, const ClosedBody& body,
                                 const BodyQuery& query, const Progress& progress);

/// `cutStiffness` of a kind.
double cutStiffnessOf(LatticeKind kind, double spacing);

} // namespace esm

#pragma once

#include "core/model/lattice.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace esm {

/// A site of the cell, or the same of a cell beside it.
struct CellSite {
    std::uint32_t site;
    Eigen::Vector3i cell; ///< how many cells away, in x, y and z
};

/// A spring of the lattice, from a site of this cell.
struct CellSpring {
    std::uint32_t first;
    CellSite second;
    double constant; ///< relative: 1 for nearest neighbours
};

/// A part of a spring's constant that lies in a tetrahedron.
struct SpringShare {
    CellSite first, second;
    double constant; ///< relative
    double length;   ///< of the spring, in spacings
};

/// One tetrahedron, its corners in positive order, and the springs that run in it or along it.
struct CellTetrahedron {
    std::array<CellSite, 4> corners;
    std::vector<SpringShare> shares;
    double volume; ///< in spacings³
};

/// What repeats in a lattice in all three directions: a cube with its sites, the springs that begin at them
/// and tetrahedra that fill it without gaps.
struct UnitCell {
    double edge;                        ///< of the cube, in spacings
    std::vector<Eigen::Vector3d> sites; ///< in spacings, from the cube's corner
    std::vector<CellSpring> springs;
    std::vector<CellTetrahedron> tetrahedra;

    /// In spacings.
    Eigen::Vector3d placeOf(const CellSite& site) const {
        return sites[site.site] + edge * site.cell.cast<double>();
    }
    /// Sites in a spacing³.
    double density() const { return static_cast<double>(sites.size()) / (edge * edge * edge); }
};

/// Made once per kind. Of the cubic lattice it is a cube of 2 × 2 × 2 cubes, as neighbouring cubes are split
/// into tetrahedra the other way round; of the graded one it is that at the surface.
/// Precondition: no prisms.
const UnitCell& unitCellOf(LatticeKind kind);

} // namespace esm

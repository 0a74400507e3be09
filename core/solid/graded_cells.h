#pragma once

#include "core/solid/box_grid.h"
#include "core/solid/closed_body.h"
#include "core/support/progress.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace esm {

/// How often a cube may double in width.
inline constexpr int mostDoublings = 2;

/// How deep corners and middle of a cube lie that is doubled, in its own widths.
inline constexpr double leastDepth = 0.65;

/// Cubes over a box around a body, wider deep within it, where neighbours are alike or of twice the width.
/// Places are counted in half edges of the finest cubes, from the box's corner: corners of cubes are even in
/// x, y and z, the middles of the finest ones odd, and no two of all these coincide.
struct GradedCells {
    Eigen::Vector3d origin;              ///< m
    double edge;                         ///< of the finest cubes, m
    BoxGrid grid;                        ///< of the finest cubes; the widest fit into it
    std::vector<std::uint8_t> doublings; ///< per finest cube, of the cube that it is part of

    int doublingsAt(const Eigen::Vector3i& cell) const { return doublings[grid.numberOf(cell)]; }
    Eigen::Vector3d placeOf(const Eigen::Vector3i& halfEdges) const {
        return origin + edge / 2 * halfEdges.cast<double>();
    }
};

/// A tetrahedron between cubes.
struct GradedTetrahedron {
    std::array<Eigen::Vector3i, 4> corners; ///< in half edges of the finest cubes, in positive order
    /// Whether it is one of a lattice of equal cubes; else it lies between cubes of two widths.
    bool isOfLattice;
    int doublings; ///< of the finest cube at it

    double volume() const; ///< in cubes of half the finest edge
};

/// @param edge of the finest cubes, m
/// @throws InvalidModel where the box has too many; Cancelled
GradedCells gradedCells(double edge, const ClosedBody& body, const BodyQuery& query,
                        const Progress& progress);

/// Those that the cube with this finest one at its first corner shares with its neighbours, each once; none
/// for finest cubes elsewhere in theirs. All together they fill the cubes but for the pyramid, a sixth of a
/// cube, over each face at the grid's hull.
std::vector<GradedTetrahedron> tetrahedraAt(const GradedCells& cells, const Eigen::Vector3i& cell);

} // namespace esm

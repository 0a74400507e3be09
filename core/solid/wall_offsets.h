#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/lattice.h"
#include "core/solid/prism.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

/// How far a wall reaches inwards from each vertex of a surface.
struct WallOffsets {
    std::vector<std::uint32_t> order; ///< per vertex; diagonals of prisms lead inwards from lower to higher
    std::vector<Eigen::Vector3d> inwards; ///< per vertex, m: from the surface to the wall's inner side
    /// Per triangle, whether no prism lies under it: where the surface is folded or runs through itself.
    std::vector<char> isLeftOut;
    std::size_t shortened = 0; ///< vertices where the wall is thinner than asked by more than a hundredth
    double least = 0;          ///< of all vertices, m
};

/// The nodes of a wall, those of the surface first, then those beneath each layer.
std::vector<Eigen::Vector3d> wallNodes(const std::vector<Eigen::Vector3d>& vertices,
                                       const WallOffsets& offsets, int layers);

/// Where the wall fits as thick as it is asked for, it is so; elsewhere it is thinner, evenly: where the
/// opposite wall is near, where the surface bends more sharply than the wall is thick, and where its inner
/// side would run through itself. No tetrahedron is flat or inside out: under the few triangles where
/// the surface is folded over, runs through itself, or bends so sharply that less than a hundredth of the
/// wall would fit, there are none.
/// @param mesh of which triangles use every vertex
/// @throws InvalidModel where the surface branches, where it is too thin, and where more than one in fifty
/// triangles would have no prism, with the place; Cancelled
WallOffsets wallOffsets(const TriangleMesh& mesh, const LatticeFilling& filling,
                        const Progress& progress = {});

} // namespace esm

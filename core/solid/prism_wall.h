#pragma once

#include "core/solid/filled_body.h"

#include <cstddef>

namespace esm {

/// A wall of prisms beneath a surface [R 3.3.2].
struct PrismWall {
    std::vector<Eigen::Vector3d> nodes;     ///< m; those of the surface first, in the order of its vertices
    std::vector<std::uint32_t> vertexNodes; ///< per vertex; 0 where no triangle uses it
    /// Edges of the tetrahedra, with those that prisms which were left out would have; constants as
    /// `Lattice::springShares`.
    std::vector<LatticeSpring> springs;
    std::vector<Tetrahedron> tetrahedra;
    std::size_t shortened = 0; ///< places where the wall is thinner than asked for
    double leastThickness = 0; ///< m
};

/// Mean length of the triangles' sides; 0 where there is no triangle.
double meanEdgeOf(const TriangleMesh& mesh);

/// Two, with which a wall bends as it should, or so many more that none is thicker than three quarters of the
/// triangles' sides: taller prisms give way to stretching.
/// @param meanEdge of the surface, m; 0 where it has none
int usualLayers(double meanEdge, double wallThickness);
int usualLayers(const TriangleMesh& mesh, double wallThickness);

/// Puts a wall beneath a surface, closed or open, of one part or several. Along the surface it is as stiff as
/// a sheet of the tissue's modulus and its own thickness, and in two layers or more it resists bending as a
/// plate of that does, in one three times as much; how nearly: docs/prism-walls.md. All constants are
/// positive.
/// @throws InvalidModel as `wallOffsets()` does, for a thickness that is no positive number, and for more
/// than `mostLatticeNodes`; Cancelled
PrismWall prismWall(const TriangleMesh& mesh, const LatticeFilling& filling, const Progress& progress = {});

/// What a wall comes to: counts are exact but for prisms that are left out.
/// @throws InvalidModel for a thickness that is no positive number, or no surface
LatticeEstimate estimateWall(const TriangleMesh& mesh, const LatticeFilling& filling);

/// How nearly a wall comes to what was asked for.
struct WallFit {
    std::size_t places;  ///< vertices beneath which it lies
    std::size_t thinner; ///< of them where it is thinner than asked for by more than a hundredth
    double least;        ///< m, where it is thinnest
    std::size_t leftOut; ///< triangles under which there is no prism
};

/// Of the nodes of a wall, whether just made or read from a file.
/// @param triangles of the surface that it lies beneath
WallFit wallFitOf(const std::vector<Eigen::Vector3d>& nodes, const Lattice& wall, std::size_t triangles);

/// Whether a wall is so often thinner than asked for, at more than one place in ten, that it is another wall.
bool isOftenThinner(const WallFit& fit);

} // namespace esm

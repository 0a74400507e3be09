#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/model/spring_network.h"
#include "core/support/progress.h"

#include <vector>

namespace esm {

/// How much of its tissue's constant each spring of a surface takes, so that the surface stretches like one
/// even sheet however it is meshed. Factor 1 is a spring within the regular triangular net, of which a
/// constant c (N/m) makes a sheet of modulus 2c/√3 (N/m: Young's modulus times thickness) and Poisson's ratio
/// 1/3; a border edge of that net has ½. Viscosity takes the same factor: the time d/c in which tissue
/// relaxes is then the same everywhere.
///
/// Per spring, from 0.05 to 10; 1 for a spring that runs along no edge of the triangles. Springs are taken at
/// the distance of their nodes. Size, order and numbering change nothing beyond rounding. How near it comes
/// to the sheet, and on which meshes it cannot: docs/net-elasticity.md.
/// Preconditions: springs and triangles name nodes that there are; no two springs join the same nodes;
/// neighbouring triangles face the same way, as repair() makes them (where they do not, a patch is measured
/// wrongly).
/// @throws Cancelled
std::vector<double> netFactors(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                               const std::vector<Triangle>& triangles, const Progress& progress = {});

/// The part of the surface that each node stands for, m²: a third of each triangle at it. What tissue has per
/// area (mass, tethers, drag) a node has by it. Together they are the surface's area; a node of no triangle
/// has none.
std::vector<double> nodeAreas(const std::vector<Eigen::Vector3d>& nodes,
                              const std::vector<Triangle>& triangles);

/// What makes a surface of springs an even sheet: `netFactors()`, and `nodeAreas()` over their mean. No node
/// stands for less than 0.3 of the mean: the debris of meshes has nodes of 10⁻⁴, and what weighs that little
/// makes the steps of a simulation a hundred times shorter; and none for more than 300 of it, as the far
/// corners of a cap do. A node of no triangle stands for the mean.
/// Preconditions and errors: those of `netFactors()`
SheetShares sheetShares(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Spring>& springs,
                        const std::vector<Triangle>& triangles, const Progress& progress = {});

} // namespace esm

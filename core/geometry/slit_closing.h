#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

/// Stitches borders that lie no farther apart than `width`, in the unit of the vertices: both sides become
/// one line half-way between them. No vertex is added; a vertex of one side that has none opposite divides
/// the edge there. Nothing but borders is joined, and nothing where a triangle would fold over or an edge get
/// more than two triangles. Triangles have to agree in orientation (`orientTriangles()`).
/// @return how many border edges are none any more
/// @throws Cancelled
std::size_t closeSlits(std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles, double width,
                       const Progress& progress = {});

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"

#include <cstddef>
#include <vector>

namespace esm {

struct ClosedSlits {
    std::size_t edges = 0; ///< of the borders there were, none any more
    /// Of each triangle there is now, the former one that it is or is part of; `noIndex` where it fills the
    /// end of a slit.
    std::vector<std::uint32_t> origins;
};

/// Stitches borders that lie no farther apart than `width`, in the unit of the vertices: both sides become
/// one line half-way between them. No vertex is added; a vertex of one side that has none opposite divides
/// the edge there. Nothing but borders is joined, and nothing where a triangle would fold over or an edge get
/// more than two triangles. Triangles have to agree in orientation (`orientTriangles()`).
/// @throws Cancelled
ClosedSlits closeSlits(std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles, double width,
                       const Progress& progress = {});

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/support/progress.h"
#include "core/texture/atlas/patch_row.h"

#include <array>
#include <vector>

namespace esm {

/// Triangles that are neighbours on the surface and in the plane: each keeps its shape, and those that share
/// an edge of the tree in which they were unfolded share it in the plane too. A triangle without area is a
/// point and a group of its own.
struct UnfoldedGroup {
    std::vector<std::uint32_t> triangles;
    std::vector<std::array<Eigen::Vector2d, 3>> corners; ///< of each, in the mesh's order, m
    double area = 0;                                     ///< m²
};

/// Every triangle in one group. No group overlaps itself, and triangles of one that share no corner there
/// are `clearance` (m) apart. Seen from outside, y is up.
/// @param shapes of all triangles, in the mesh's order
std::vector<UnfoldedGroup> unfold(const TriangleMesh& mesh, const std::vector<PatchShape>& shapes,
                                  double clearance, const Progress& progress = {});

} // namespace esm

#pragma once

#include "core/geometry/triangle_mesh.h"

#include <vector>

namespace esm {

/// Turns triangles so that neighbours agree across every edge of two triangles, as far as that is possible;
/// never across an edge of more. What hangs together so faces outwards when it is closed, else keeps the
/// direction of most of its triangles.
/// @return for each triangle whether it was turned
std::vector<bool> orientTriangles(const std::vector<Eigen::Vector3d>& vertices,
                                  std::vector<Triangle>& triangles);

} // namespace esm

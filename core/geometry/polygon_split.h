#pragma once

#include "core/geometry/triangle_mesh.h"

namespace esm {

/// Splits a polygon into triangles of the same direction of travel: a fan from the first corner when it is
/// convex there, else by cutting off ears in the polygon's mean plane. A polygon of n corners gives n − 2
/// triangles, also when it crosses itself and no split is right.
/// @param polygon vertex indices, three or more
std::vector<Triangle> splitPolygon(const std::vector<Eigen::Vector3d>& vertices,
                                   const std::vector<std::uint32_t>& polygon);

} // namespace esm

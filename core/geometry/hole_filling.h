#pragma once

#include "core/geometry/border_loops.h"
#include "core/support/progress.h"

namespace esm {

/// Holes with more edges take seconds, as the time grows with the cube of their number.
inline constexpr std::size_t mostHoleEdges = 500;

/// Fills holes with triangles between the vertices of their borders, in the direction of the surface around
/// them. A loop is left open where every filling would fold back onto the surface, as at the outer border of
/// a sheet, or give an edge more than two triangles.
/// @param loops of the triangles, each of at most `mostHoleEdges`
/// @return for each loop whether it was filled
/// @throws Cancelled
std::vector<bool> fillHoles(const std::vector<Eigen::Vector3d>& vertices, std::vector<Triangle>& triangles,
                            const std::vector<BorderLoop>& loops, const Progress& progress = {});

} // namespace esm

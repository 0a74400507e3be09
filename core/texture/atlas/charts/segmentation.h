#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/charts/dual_graph.h"

namespace esm {

using TriangleSet = std::vector<std::uint32_t>; ///< rising numbers

/// Cuts a surface into round pieces that turn little, each joined by its edges: what has a chance to be laid
/// flat with little distortion. Whether it can is for others to find out. Triangles without area are left
/// out. @throws Cancelled
std::vector<TriangleSet> segments(const DualGraph& surface, const Progress& progress);

/// Two pieces of a graph of two triangles or more that is in one piece, and either in one piece.
std::array<TriangleSet, 2> halves(const DualGraph& graph);

} // namespace esm
